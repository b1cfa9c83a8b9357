package org.dronemap.store.memory;

import org.dronemap.core.drone.ParameterOverrideStore;
import org.dronemap.store.contract.ParameterOverrideStoreContract;

class MemoryParameterOverrideStoreTest extends ParameterOverrideStoreContract {
    @Override
    protected ParameterOverrideStore emptyStore() {
        return new MemoryParameterOverrideStore();
    }
}
