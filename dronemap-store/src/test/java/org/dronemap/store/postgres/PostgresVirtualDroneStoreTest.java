package org.dronemap.store.postgres;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneRecord;
import org.dronemap.core.virtual.VirtualDroneStore;
import org.dronemap.store.contract.VirtualDroneStoreContract;
import org.junit.jupiter.api.Test;

class PostgresVirtualDroneStoreTest extends VirtualDroneStoreContract {
    private final PostgresStores database = SharedDatabase.empty();

    @Override
    protected VirtualDroneStore emptyStore(List<DroneRecord> drones) {
        drones.forEach(drone -> database.drones().save(drone));
        return database.virtualDrones();
    }

    @Test
    void takesADroneThatIsForgottenOutOfTheWarehouse() {
        DroneId drone = new DroneId("copter-1");
        database.virtualDrones().addToWarehouse(drone);

        database.drones().delete(drone);

        assertThat(database.virtualDrones().warehouse()).isEmpty();
    }
}
