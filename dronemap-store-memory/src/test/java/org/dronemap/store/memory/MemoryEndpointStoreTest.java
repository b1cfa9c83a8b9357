package org.dronemap.store.memory;

import org.dronemap.core.link.EndpointStore;
import org.dronemap.store.contract.EndpointStoreContract;

class MemoryEndpointStoreTest extends EndpointStoreContract {
    @Override
    protected EndpointStore emptyStore() {
        return new MemoryEndpointStore();
    }
}
