package org.dronemap.store.postgres;

import org.dronemap.core.mission.MissionStore;
import org.dronemap.store.contract.MissionStoreContract;

class PostgresMissionStoreTest extends MissionStoreContract {
    @Override
    protected MissionStore emptyStore() {
        return SharedDatabase.empty().missions();
    }
}
