package org.dronemap.store.memory;

import org.dronemap.core.access.AccessStore;
import org.dronemap.store.contract.AccessStoreContract;

class MemoryAccessStoreTest extends AccessStoreContract {
    @Override
    protected AccessStore emptyStore() {
        return new MemoryAccessStore();
    }
}
