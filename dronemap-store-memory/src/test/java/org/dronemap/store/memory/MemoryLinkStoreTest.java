package org.dronemap.store.memory;

import org.dronemap.core.link.LinkStore;
import org.dronemap.store.contract.LinkStoreContract;

class MemoryLinkStoreTest extends LinkStoreContract {
    @Override
    protected LinkStore emptyStore() {
        return new MemoryLinkStore();
    }
}
