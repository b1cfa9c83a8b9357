package org.dronemap.store.postgres;

import org.dronemap.core.drone.ParameterOverrideStore;
import org.dronemap.store.contract.ParameterOverrideStoreContract;

class PostgresParameterOverrideStoreTest extends ParameterOverrideStoreContract {
    @Override
    protected ParameterOverrideStore emptyStore() {
        return SharedDatabase.empty().owners();
    }
}
