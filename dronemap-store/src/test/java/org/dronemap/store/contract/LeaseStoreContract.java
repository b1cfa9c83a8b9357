package org.dronemap.store.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.List;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneRecord;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.lease.LeaseStore;
import org.dronemap.core.lease.SavedLease;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What every {@link LeaseStore} keeps to. */
public abstract class LeaseStoreContract {
    protected static final Instant THEN = Instant.parse("2026-03-04T05:06:07.123456Z");
    private static final DroneId ONE = new DroneId("copter-1");
    private static final DroneId OTHER = new DroneId("copter-2");

    private LeaseStore store;

    /** A store without leases that knows the drones copter-1 and copter-2. */
    protected abstract LeaseStore emptyStore(List<DroneRecord> drones);

    @BeforeEach
    void open() {
        store = emptyStore(List.of(drone(ONE), drone(OTHER)));
    }

    private static DroneRecord drone(DroneId id) {
        return new DroneRecord(
                id,
                "Copter",
                new DroneKey("127.0.0.1", 14601, 1),
                "udp",
                new Identification(VehicleKind.MULTICOPTER, "ArduPilot", "ArduCopter", "4.5.6", null),
                THEN);
    }

    @Test
    void keepsOneLeaseForEachDrone() {
        SavedLease first = new SavedLease(ONE, "ann", THEN, 3, false);
        SavedLease second = new SavedLease(ONE, "bob", THEN.plusSeconds(1), 4, true, "LOITER");
        SavedLease other = new SavedLease(OTHER, "ann", THEN, 3, false);

        store.save(other);
        store.save(first);
        assertThat(store.leases()).containsExactly(first, other);

        store.save(second);
        store.delete(OTHER);
        assertThat(store.leases()).containsExactly(second);
        store.delete(OTHER);
    }

    @Test
    void neverSetsTheSameEpochsAsideTwice() {
        long first = store.reserve(100);
        long second = store.reserve(10);

        assertThat(first).isGreaterThanOrEqualTo(100);
        assertThat(second - first).isGreaterThanOrEqualTo(10);
    }
}
