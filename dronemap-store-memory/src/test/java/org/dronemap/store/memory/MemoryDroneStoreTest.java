package org.dronemap.store.memory;

import org.dronemap.core.drone.DroneStore;
import org.dronemap.store.contract.DroneStoreContract;

class MemoryDroneStoreTest extends DroneStoreContract {
    @Override
    protected DroneStore emptyStore() {
        return new MemoryDroneStore();
    }
}
