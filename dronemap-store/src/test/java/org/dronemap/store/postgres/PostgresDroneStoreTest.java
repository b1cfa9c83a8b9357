package org.dronemap.store.postgres;

import org.dronemap.core.drone.DroneStore;
import org.dronemap.store.contract.DroneStoreContract;

class PostgresDroneStoreTest extends DroneStoreContract {
    @Override
    protected DroneStore emptyStore() {
        return SharedDatabase.empty().drones();
    }
}
