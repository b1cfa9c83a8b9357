package org.dronemap.store.memory;

import org.dronemap.core.access.GrantStore;
import org.dronemap.store.contract.GrantStoreContract;

class MemoryGrantStoreTest extends GrantStoreContract {
    @Override
    protected GrantStore emptyStore() {
        return new MemoryGrantStore();
    }
}
