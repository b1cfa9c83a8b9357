package org.dronemap.store.memory;

import org.dronemap.core.history.FlightStore;
import org.dronemap.store.contract.FlightStoreContract;

class MemoryFlightStoreTest extends FlightStoreContract {
    @Override
    protected FlightStore emptyStore() {
        return new MemoryFlightStore();
    }
}
