package org.dronemap.store.postgres;

import org.dronemap.core.access.AccessStore;
import org.dronemap.store.contract.AccessStoreContract;

class PostgresAccessStoreTest extends AccessStoreContract {
    @Override
    protected AccessStore emptyStore() {
        return SharedDatabase.empty().access();
    }
}
