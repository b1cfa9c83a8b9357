package org.dronemap.core.zone;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.IdentityTrust;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.LinkStatus;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.drone.PayloadState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.FenceArea;
import org.jspecify.annotations.Nullable;

/** Zones and drones around a place near Zürich; 0.001 degrees are 111 m to the north and 75 m to the east there. */
final class ZoneFixtures {
    static final Instant NOW = Instant.parse("2026-05-04T10:00:00Z");
    static final Geodetic HOME = new Geodetic(47.4, 8.5);
    static final DroneId DRONE = new DroneId("drone-1");

    private ZoneFixtures() {}

    static Geodetic at(double northDegrees, double eastDegrees) {
        return new Geodetic(HOME.latitudeDegrees() + northDegrees, HOME.longitudeDegrees() + eastDegrees);
    }

    /** A square with this middle, 0.002 degrees wide. */
    static FenceArea square(boolean inside, double north, double east) {
        return new FenceArea.Polygon(
                inside,
                List.of(
                        at(north - 0.001, east - 0.001),
                        at(north - 0.001, east + 0.001),
                        at(north + 0.001, east + 0.001),
                        at(north + 0.001, east - 0.001)));
    }

    static Zone zone(FenceArea shape) {
        return zone(shape, AltitudeBand.ALL);
    }

    static Zone zone(FenceArea shape, AltitudeBand band) {
        return zone(shape, band, ZoneBinding.EVERYBODY, ZoneValidity.ALWAYS);
    }

    static Zone zone(FenceArea shape, AltitudeBand band, ZoneBinding binding, ZoneValidity validity) {
        return new Zone("z1", "Airport", shape, band, binding, validity, BreachAction.HOLD, "ann", NOW);
    }

    static DroneState onGround(@Nullable Geodetic point) {
        return drone(point, 0, FlightPhase.ON_GROUND, MissionProgress.UNKNOWN);
    }

    static DroneState flying(Geodetic point, double aboveHome) {
        return drone(point, aboveHome, FlightPhase.IN_AIR, MissionProgress.UNKNOWN);
    }

    static DroneState drone(@Nullable Geodetic point, double aboveHome, FlightPhase phase, MissionProgress mission) {
        DroneKey key = new DroneKey("127.0.0.1", 14601, 1);
        return new DroneState(
                DRONE,
                "Copter 1",
                false,
                new LinkStatus(key, "udp", LinkState.LIVE, NOW, LinkQuality.UNKNOWN, List.of()),
                new Identification(VehicleKind.MULTICOPTER, "ArduPilot", "ArduCopter", "4.5.6", null),
                IdentityTrust.UNPROVED,
                new Capabilities(
                        Set.of(Capability.values()),
                        List.of("GUIDED", "AUTO", "CIRCLE"),
                        Map.of("GUIDED", Steering.ORDERS, "AUTO", Steering.MISSION, "RTL", Steering.SAFETY)),
                "GUIDED",
                phase != FlightPhase.ON_GROUND,
                true,
                phase,
                point == null ? null : new Position(point, 450 + aboveHome, aboveHome),
                null,
                null,
                null,
                null,
                null,
                new Home(HOME, 450),
                null,
                PayloadState.UNKNOWN,
                mission,
                List.of(),
                NOW,
                1,
                null);
    }
}
