package org.dronemap.store.postgres;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronemap.core.drone.DroneRecord;
import org.dronemap.core.drone.DroneStore;
import org.dronemap.core.lease.LeaseStore;
import org.dronemap.core.lease.SavedLease;
import org.dronemap.store.contract.LeaseStoreContract;
import org.junit.jupiter.api.Test;

class PostgresLeaseStoreTest extends LeaseStoreContract {
    private List<DroneRecord> known = List.of();
    private DroneStore droneStore = SharedDatabase.empty().drones();

    @Override
    protected LeaseStore emptyStore(List<DroneRecord> drones) {
        PostgresStores database = SharedDatabase.empty();
        known = drones;
        droneStore = database.drones();
        drones.forEach(droneStore::save);
        return database.leases();
    }

    @Test
    void forgetsTheLeaseOfADroneThatIsForgotten() {
        LeaseStore store = emptyStore(known);
        store.save(new SavedLease(known.get(0).id(), "ann", THEN, 1, false));

        droneStore.delete(known.get(0).id());

        assertThat(store.leases()).isEmpty();
    }
}
