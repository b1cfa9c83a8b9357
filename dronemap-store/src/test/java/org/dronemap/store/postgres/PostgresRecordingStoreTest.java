package org.dronemap.store.postgres;

import org.dronemap.core.recording.RecordingStore;
import org.dronemap.store.contract.RecordingStoreContract;

class PostgresRecordingStoreTest extends RecordingStoreContract {
    @Override
    protected RecordingStore emptyStore() {
        return SharedDatabase.empty().recordings();
    }
}
