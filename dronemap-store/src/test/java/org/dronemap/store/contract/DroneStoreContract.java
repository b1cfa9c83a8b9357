package org.dronemap.store.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Instant;
import java.util.List;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneRecord;
import org.dronemap.core.drone.DroneStore;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.IdentityEvidence;
import org.dronemap.core.drone.IdentityTrust;
import org.dronemap.core.drone.KnownMission;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.store.StoreException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What every {@link DroneStore} keeps to. */
public abstract class DroneStoreContract {
    private static final DroneId COPTER = new DroneId("d7k2m9q4xa");
    private static final Instant HEARD = Instant.parse("2026-03-04T05:06:07.123456Z");

    private DroneStore store;

    /** An empty store. */
    protected abstract DroneStore emptyStore();

    @BeforeEach
    void open() {
        store = emptyStore();
    }

    @Test
    void isEmptyAtFirst() {
        assertThat(store.drones()).isEmpty();
        assertThat(store.knownMission(COPTER)).isEmpty();
    }

    @Test
    void givesBackADroneWithEveryFact() {
        DroneRecord drone = copter("Copter 1 — Zürich 🚁", "4.5.6", "0123abcd");
        store.save(drone);
        assertThat(store.drones()).containsExactly(drone);
    }

    @Test
    void keepsUnknownFactsUnknown() {
        DroneRecord drone = copter("Copter 1", null, null);
        store.save(drone);
        assertThat(store.drones()).containsExactly(drone);
    }

    @Test
    void keepsEveryVehicleKind() {
        for (VehicleKind kind : VehicleKind.values()) {
            DroneRecord drone = new DroneRecord(
                    COPTER,
                    "one",
                    new DroneKey("::1", 65535, 255),
                    "tcp",
                    new Identification(kind, "PX4", "PX4", null, null),
                    IdentityTrust.UNPROVED,
                    HEARD,
                    512.25);
            store.save(drone);
            assertThat(store.drones()).containsExactly(drone);
        }
    }

    @Test
    void keepsHowADroneShowedWhoItIs() {
        for (IdentityEvidence evidence : IdentityEvidence.values()) {
            for (IdentityTrust standing :
                    List.of(new IdentityTrust(evidence, null, false), new IdentityTrust(evidence, "key 7", true))) {
                DroneRecord drone = new DroneRecord(
                        COPTER,
                        "one",
                        new DroneKey("::1", 65535, 255),
                        "dtls",
                        new Identification(VehicleKind.BOAT, "PX4", "PX4", null, null),
                        standing,
                        HEARD,
                        null);
                store.save(drone);
                assertThat(store.drones()).containsExactly(drone);
            }
        }
    }

    @Test
    void replacesADroneThatIsSavedAgain() {
        store.save(copter("before", null, null));
        DroneRecord after = copter("after", "4.6.0", "ff");
        store.save(after);
        assertThat(store.drones()).containsExactly(after);
    }

    @Test
    void cutsTimesToTheMicrosecond() {
        DroneRecord drone = copter("one", null, null);
        store.save(new DroneRecord(
                drone.id(),
                drone.name(),
                drone.key(),
                drone.transport(),
                drone.identification(),
                drone.standing(),
                HEARD.plusNanos(999),
                null));
        assertThat(store.drones()).containsExactly(drone);
    }

    @Test
    void givesBackTheKnownMissionWithEveryKindOfItem() {
        store.save(copter("one", null, null));
        KnownMission mission = new KnownMission(
                List.of(
                        new MissionItem.TakeOff(20),
                        new MissionItem.Waypoint(
                                new Geodetic(47.39774195, -8.5455938), Altitude.aboveHome(0.1 + 0.2), 0.1),
                        new MissionItem.Waypoint(
                                new Geodetic(-90, 180), new Altitude(-400.5, Altitude.Reference.AMSL), 0),
                        new MissionItem.Other("camera trigger \"every\" 5 m\n"),
                        new MissionItem.ReturnToLaunch(),
                        new MissionItem.Land()),
                "5f0c2a",
                3);
        store.saveKnownMission(COPTER, mission);
        assertThat(store.knownMission(COPTER)).contains(mission);
    }

    @Test
    void tellsAnEmptyMissionFromAnUnknownOne() {
        store.save(copter("one", null, null));
        store.saveKnownMission(COPTER, new KnownMission(List.of(), null));
        assertThat(store.knownMission(COPTER)).contains(new KnownMission(List.of(), null));
    }

    @Test
    void replacesTheKnownMission() {
        store.save(copter("one", null, null));
        store.saveKnownMission(COPTER, new KnownMission(List.of(new MissionItem.Land()), 0));
        KnownMission second = new KnownMission(List.of(new MissionItem.ReturnToLaunch()), null);
        store.saveKnownMission(COPTER, second);
        assertThat(store.knownMission(COPTER)).contains(second);
    }

    @Test
    void keepsTheKnownMissionWhenTheDroneIsSavedAgain() {
        store.save(copter("one", null, null));
        KnownMission mission = new KnownMission(List.of(new MissionItem.Land()), 0);
        store.saveKnownMission(COPTER, mission);
        store.save(copter("two", null, null));
        assertThat(store.knownMission(COPTER)).contains(mission);
    }

    @Test
    void refusesAMissionOfADroneThatItDoesNotKnow() {
        KnownMission mission = new KnownMission(List.of(), null);
        assertThatThrownBy(() -> store.saveKnownMission(COPTER, mission)).isInstanceOf(StoreException.class);
        assertThat(store.knownMission(COPTER)).isEmpty();
    }

    @Test
    void forgetsADroneWithItsMission() {
        store.save(copter("one", null, null));
        store.saveKnownMission(COPTER, new KnownMission(List.of(new MissionItem.Land()), 0));
        store.delete(COPTER);
        store.delete(new DroneId("never-known"));
        assertThat(store.drones()).isEmpty();
        assertThat(store.knownMission(COPTER)).isEmpty();
    }

    private static DroneRecord copter(String name, String firmware, String hardwareUid) {
        return new DroneRecord(
                COPTER,
                name,
                new DroneKey("127.0.0.1", 14601, 1),
                "udp",
                new Identification(VehicleKind.MULTICOPTER, "ArduPilot", "ArduCopter", firmware, hardwareUid),
                IdentityTrust.UNPROVED,
                HEARD,
                null);
    }
}
