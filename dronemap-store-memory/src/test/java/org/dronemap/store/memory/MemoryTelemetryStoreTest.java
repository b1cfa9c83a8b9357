package org.dronemap.store.memory;

import org.dronemap.core.history.TelemetryStore;
import org.dronemap.store.contract.TelemetryStoreContract;

class MemoryTelemetryStoreTest extends TelemetryStoreContract {
    @Override
    protected TelemetryStore emptyStore() {
        return new MemoryTelemetryStore();
    }
}
