package org.dronemap.store.postgres;

import org.dronemap.core.history.FlightStore;
import org.dronemap.store.contract.FlightStoreContract;

class PostgresFlightStoreTest extends FlightStoreContract {
    @Override
    protected FlightStore emptyStore() {
        return SharedDatabase.empty().flights();
    }
}
