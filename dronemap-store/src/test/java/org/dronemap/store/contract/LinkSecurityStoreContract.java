package org.dronemap.store.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Instant;
import org.dronemap.core.access.LinkKey;
import org.dronemap.core.access.LinkSecurity;
import org.dronemap.core.access.LinkSecurityStore;
import org.dronemap.core.access.LinkSigningPolicy;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneRecord;
import org.dronemap.core.drone.DroneStore;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.store.StoreException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What every {@link LinkSecurityStore} keeps to. */
public abstract class LinkSecurityStoreContract {
    protected static final DroneId COPTER = new DroneId("d7k2m9q4xa");

    private DroneStore drones;
    private LinkSecurityStore store;

    /** Empty stores that belong together. */
    public record Stores(DroneStore drones, LinkSecurityStore security) {}

    protected abstract Stores emptyStores();

    @BeforeEach
    void open() {
        Stores stores = emptyStores();
        drones = stores.drones();
        store = stores.security();
        drones.save(new DroneRecord(
                COPTER,
                "Copter 1",
                new DroneKey("127.0.0.1", 14601, 1),
                "udp",
                new Identification(VehicleKind.MULTICOPTER, "ArduPilot", "ArduCopter", null, null),
                Instant.parse("2026-03-04T05:06:07Z")));
    }

    @Test
    void isEmptyAtFirst() {
        assertThat(store.all()).isEmpty();
    }

    @Test
    void givesBackKeysAndPolicy() {
        LinkSecurity security = new LinkSecurity(COPTER, LinkSigningPolicy.REQUIRED, key(1), key(2), true, 1L << 47);
        store.save(security);
        assertThat(store.all()).containsExactly(security);
    }

    @Test
    void replacesWhatWasThere() {
        store.save(new LinkSecurity(COPTER, LinkSigningPolicy.REQUIRED, key(1), key(2), true, 7));
        LinkSecurity after = new LinkSecurity(COPTER, LinkSigningPolicy.OFF, null, null, false, 9);
        store.save(after);
        assertThat(store.all()).containsExactly(after);
    }

    @Test
    void keepsEveryPolicy() {
        for (LinkSigningPolicy policy : LinkSigningPolicy.values()) {
            LinkSecurity security = new LinkSecurity(COPTER, policy, key(3), null, false, 5);
            store.save(security);
            assertThat(store.all()).containsExactly(security);
        }
    }

    @Test
    void aStampOnlyRises() {
        store.save(new LinkSecurity(COPTER, LinkSigningPolicy.OPTIONAL, key(1), null, false, 100));
        store.saveStamp(COPTER, 200);
        store.saveStamp(COPTER, 150);
        store.save(new LinkSecurity(COPTER, LinkSigningPolicy.OPTIONAL, key(1), null, true, 100));
        assertThat(store.all())
                .containsExactly(new LinkSecurity(COPTER, LinkSigningPolicy.OPTIONAL, key(1), null, true, 200));
    }

    @Test
    void aStampOfADroneWithoutSecurityIsNobodys() {
        store.saveStamp(COPTER, 200);
        store.saveStamp(new DroneId("never-known"), 200);
        assertThat(store.all()).isEmpty();
    }

    @Test
    void goesWithItsDrone() {
        store.save(new LinkSecurity(COPTER, LinkSigningPolicy.REQUIRED, key(1), null, true, 1));
        drones.delete(COPTER);
        assertThat(store.all()).isEmpty();
    }

    @Test
    void refusesADroneThatItDoesNotKnow() {
        LinkSecurity stranger = LinkSecurity.none(new DroneId("never-known"));
        assertThatThrownBy(() -> store.save(stranger)).isInstanceOf(StoreException.class);
    }

    protected static LinkKey key(int first) {
        byte[] secret = new byte[LinkKey.BYTES];
        for (int i = 0; i < secret.length; i++) {
            secret[i] = (byte) (first + i);
        }
        return new LinkKey(secret);
    }
}
