package org.dronemap.store.memory;

import org.dronemap.store.contract.OutletStoreContract;

class MemoryOutletStoreTest extends OutletStoreContract {
    @Override
    protected Stores emptyStores() {
        MemoryAccessStore access = new MemoryAccessStore();
        MemoryDroneStore drones = new MemoryDroneStore();
        return new Stores(access, drones, new MemoryOutletStore(access, drones));
    }
}
