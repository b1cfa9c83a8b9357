package org.dronemap.store.memory;

import org.dronemap.core.mission.MissionStore;
import org.dronemap.store.contract.MissionStoreContract;

class MemoryMissionStoreTest extends MissionStoreContract {
    @Override
    protected MissionStore emptyStore() {
        return new MemoryMissionStore();
    }
}
