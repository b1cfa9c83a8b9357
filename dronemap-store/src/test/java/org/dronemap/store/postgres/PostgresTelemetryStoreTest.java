package org.dronemap.store.postgres;

import org.dronemap.core.history.TelemetryStore;
import org.dronemap.store.contract.TelemetryStoreContract;

class PostgresTelemetryStoreTest extends TelemetryStoreContract {
    @Override
    protected TelemetryStore emptyStore() {
        return SharedDatabase.empty().telemetry();
    }
}
