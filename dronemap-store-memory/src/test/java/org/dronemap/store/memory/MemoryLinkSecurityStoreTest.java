package org.dronemap.store.memory;

import org.dronemap.store.contract.LinkSecurityStoreContract;

class MemoryLinkSecurityStoreTest extends LinkSecurityStoreContract {
    @Override
    protected Stores emptyStores() {
        MemoryDroneStore drones = new MemoryDroneStore();
        return new Stores(drones, new MemoryLinkSecurityStore(drones));
    }
}
