package org.dronemap.store.postgres;

import org.dronemap.core.drone.OwnersStore;
import org.dronemap.store.contract.OwnersStoreContract;

class PostgresOwnersStoreTest extends OwnersStoreContract {
    @Override
    protected OwnersStore emptyStore() {
        return SharedDatabase.empty().owners();
    }
}
