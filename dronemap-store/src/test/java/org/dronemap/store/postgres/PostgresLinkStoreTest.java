package org.dronemap.store.postgres;

import org.dronemap.core.link.LinkStore;
import org.dronemap.store.contract.LinkStoreContract;

class PostgresLinkStoreTest extends LinkStoreContract {
    @Override
    protected LinkStore emptyStore() {
        return SharedDatabase.empty().links();
    }
}
