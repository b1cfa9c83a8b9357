package org.dronemap.store.memory;

import java.util.List;
import org.dronemap.core.drone.DroneRecord;
import org.dronemap.core.virtual.VirtualDroneStore;
import org.dronemap.store.contract.VirtualDroneStoreContract;

class MemoryVirtualDroneStoreTest extends VirtualDroneStoreContract {
    @Override
    protected VirtualDroneStore emptyStore(List<DroneRecord> drones) {
        return new MemoryVirtualDroneStore();
    }
}
