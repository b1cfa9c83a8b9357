package org.dronemap.store.memory;

import org.dronemap.core.recording.RecordingStore;
import org.dronemap.store.contract.RecordingStoreContract;

class MemoryRecordingStoreTest extends RecordingStoreContract {
    @Override
    protected RecordingStore emptyStore() {
        return new MemoryRecordingStore();
    }
}
