package org.dronemap.store.postgres;

import org.dronemap.core.zone.ZoneStore;
import org.dronemap.store.contract.ZoneStoreContract;

class PostgresZoneStoreTest extends ZoneStoreContract {
    @Override
    protected ZoneStore emptyStore() {
        return SharedDatabase.empty().zones();
    }
}
