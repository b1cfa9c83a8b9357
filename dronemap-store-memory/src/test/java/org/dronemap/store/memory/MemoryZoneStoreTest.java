package org.dronemap.store.memory;

import org.dronemap.core.zone.ZoneStore;
import org.dronemap.store.contract.ZoneStoreContract;

class MemoryZoneStoreTest extends ZoneStoreContract {
    @Override
    protected ZoneStore emptyStore() {
        return new MemoryZoneStore();
    }
}
