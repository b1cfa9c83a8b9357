package org.dronemap.store.memory;

import java.util.List;
import org.dronemap.core.drone.DroneRecord;
import org.dronemap.core.lease.LeaseStore;
import org.dronemap.store.contract.LeaseStoreContract;

class MemoryLeaseStoreTest extends LeaseStoreContract {
    @Override
    protected LeaseStore emptyStore(List<DroneRecord> drones) {
        return new MemoryLeaseStore();
    }
}
