package org.dronemap.store.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Instant;
import java.util.Arrays;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.AccountState;
import org.dronemap.core.access.LinkKey;
import org.dronemap.core.access.OutletKey;
import org.dronemap.core.access.OutletStore;
import org.dronemap.core.access.OutletSystemId;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.User;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneRecord;
import org.dronemap.core.drone.DroneStore;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.store.StoreException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What every {@link OutletStore} keeps to. */
public abstract class OutletStoreContract {
    protected static final DroneId COPTER = new DroneId("d7k2m9q4xa");
    private static final DroneId OTHER = new DroneId("d7k2m9q4xb");

    private Stores stores;
    private OutletStore store;

    /** Empty stores that belong together. */
    public record Stores(AccessStore access, DroneStore drones, OutletStore outlet) {}

    protected abstract Stores emptyStores();

    @BeforeEach
    void open() {
        stores = emptyStores();
        store = stores.outlet();
        for (String name : new String[] {"ann", "bob"}) {
            stores.access().addUser(new User(name, Role.VIEWER, AccountState.ACTIVE, "none", false));
        }
        drone(COPTER);
        drone(OTHER);
    }

    private void drone(DroneId id) {
        stores.drones()
                .save(new DroneRecord(
                        id,
                        "Copter",
                        new DroneKey("127.0.0.1", 14601, 1),
                        "udp",
                        new Identification(VehicleKind.MULTICOPTER, "ArduPilot", "ArduCopter", null, null),
                        Instant.parse("2026-03-04T05:06:07Z")));
    }

    @Test
    void isEmptyAtFirst() {
        assertThat(store.keys()).isEmpty();
        assertThat(store.numbers()).isEmpty();
    }

    @Test
    void givesBackWhatIsSavedAndReplacesIt() {
        store.saveKey(new OutletKey("ann", key(1), 5));
        store.saveKey(new OutletKey("bob", key(2), 1L << 47));
        assertThat(store.keys())
                .containsExactly(new OutletKey("ann", key(1), 5), new OutletKey("bob", key(2), 1L << 47));
        store.saveKey(new OutletKey("ann", key(3), 0));
        assertThat(store.keys()).contains(new OutletKey("ann", key(3), 5));
    }

    @Test
    void stampsOnlyRise() {
        store.saveKey(new OutletKey("ann", key(1), 5));
        store.saveStamp("ann", 4);
        assertThat(store.keys()).containsExactly(new OutletKey("ann", key(1), 5));
        store.saveStamp("ann", 6);
        store.saveStamp("bob", 6);
        assertThat(store.keys()).containsExactly(new OutletKey("ann", key(1), 6));
    }

    @Test
    void keysGoWhenAskedAndWithTheirUser() {
        store.saveKey(new OutletKey("ann", key(1), 5));
        store.saveKey(new OutletKey("bob", key(2), 5));
        assertThat(store.deleteKey("ann")).isTrue();
        assertThat(store.deleteKey("ann")).isFalse();
        stores.access().deleteUser("bob");
        assertThat(store.keys()).isEmpty();
    }

    @Test
    void aKeyOfNobodyIsRefused() {
        OutletKey nobodys = new OutletKey("nobody", key(1), 5);
        assertThatThrownBy(() -> store.saveKey(nobodys)).isInstanceOf(StoreException.class);
    }

    @Test
    void noNumberIsGivenTwiceToAUser() {
        store.saveNumber(new OutletSystemId("ann", COPTER, 7));
        store.saveNumber(new OutletSystemId("ann", OTHER, 7));
        store.saveNumber(new OutletSystemId("ann", COPTER, 8));
        store.saveNumber(new OutletSystemId("bob", OTHER, 7));
        assertThat(store.numbers())
                .containsExactly(new OutletSystemId("ann", COPTER, 7), new OutletSystemId("bob", OTHER, 7));
    }

    @Test
    void numbersGoWithTheirUserAndTheirDrone() {
        store.saveNumber(new OutletSystemId("ann", COPTER, 7));
        store.saveNumber(new OutletSystemId("ann", OTHER, 8));
        store.saveNumber(new OutletSystemId("bob", OTHER, 8));
        stores.drones().delete(COPTER);
        stores.access().deleteUser("bob");
        assertThat(store.numbers()).containsExactly(new OutletSystemId("ann", OTHER, 8));
    }

    @Test
    void aNumberOfADroneThatIsGoneIsNotKept() {
        store.saveNumber(new OutletSystemId("ann", new DroneId("d7k2m9q4xz"), 7));
        assertThat(store.numbers()).isEmpty();
    }

    protected static LinkKey key(int number) {
        byte[] secret = new byte[LinkKey.BYTES];
        Arrays.fill(secret, (byte) (0xA0 + number));
        return new LinkKey(secret);
    }
}
