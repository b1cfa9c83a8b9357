package org.dronemap.store.memory;

import org.dronemap.core.drone.OwnersStore;
import org.dronemap.store.contract.OwnersStoreContract;

class MemoryOwnersStoreTest extends OwnersStoreContract {
    @Override
    protected OwnersStore emptyStore() {
        return new MemoryOwnersStore();
    }
}
