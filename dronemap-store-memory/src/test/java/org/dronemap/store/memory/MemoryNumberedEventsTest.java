package org.dronemap.store.memory;

import org.dronemap.core.history.TelemetryStore;
import org.dronemap.store.contract.NumberedEventsContract;

class MemoryNumberedEventsTest extends NumberedEventsContract {
    private final MemoryTelemetryStore store = new MemoryTelemetryStore();

    @Override
    protected TelemetryStore emptyStore() {
        return store;
    }

    @Override
    protected TelemetryStore again() {
        return store;
    }
}
