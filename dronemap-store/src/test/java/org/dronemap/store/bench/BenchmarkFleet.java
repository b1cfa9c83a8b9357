package org.dronemap.store.bench;

import java.time.Instant;
import java.util.List;
import org.dronemap.core.drone.Attitude;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Gps;
import org.dronemap.core.drone.GpsFix;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.IdentityTrust;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.LinkStatus;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.drone.PayloadState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;

/** States of drones in flight, one drone after the other; each can be told from all others by its latitude. */
final class BenchmarkFleet {
    static final int DRONES = 2_000;
    /** Latitudes of two states that follow on each other are so far apart: exact enough to count by. */
    static final double DEGREES_APART = 1e-6;

    private BenchmarkFleet() {}

    static DroneId drone(long number) {
        return new DroneId("d" + (100_000 + number % DRONES));
    }

    /** {@code number}: how many there were before, of all drones. */
    static DroneState state(long number, DroneId drone, Instant at) {
        long round = number / DRONES;
        double wave = Math.sin(round / 600.0 + drone.hashCode() % 1_000);
        double turn = round * 0.3 % 360;
        return new DroneState(
                drone,
                "Drone " + drone.value(),
                false,
                new LinkStatus(
                        new DroneKey("192.0.2.1", 14550, 1),
                        "udp",
                        LinkState.LIVE,
                        at,
                        new LinkQuality(0.01, 0.01, 35.5),
                        List.of()),
                new Identification(VehicleKind.MULTICOPTER, "ArduPilot", "ArduCopter", "4.5.6", null),
                IdentityTrust.UNPROVED,
                Capabilities.UNKNOWN,
                "AUTO",
                true,
                true,
                FlightPhase.IN_AIR,
                new Position(new Geodetic(number * DEGREES_APART, 8 + wave * 0.01), 500 + 50 * wave, 50 + 50 * wave),
                null,
                new Motion(5 + wave, null, wave, turn),
                new Attitude(wave * 10, -wave * 10, turn - 180),
                new Battery(100 - (int) (round / 600) % 100, 12.6 - wave, 14.5),
                new Gps(GpsFix.THREE_D, 14, 0.8),
                null,
                null,
                PayloadState.UNKNOWN,
                MissionProgress.UNKNOWN,
                List.of(),
                at,
                number,
                null);
    }
}
