package org.dronemap.store.postgres;

import org.dronemap.core.link.EndpointStore;
import org.dronemap.store.contract.EndpointStoreContract;

class PostgresEndpointStoreTest extends EndpointStoreContract {
    @Override
    protected EndpointStore emptyStore() {
        return SharedDatabase.empty().links();
    }
}
