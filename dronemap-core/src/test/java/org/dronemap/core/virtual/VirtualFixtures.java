package org.dronemap.core.virtual;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.drone.Battery;
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
import org.dronemap.core.drone.MissionPhase;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.drone.PayloadState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.drone.Wind;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.jspecify.annotations.Nullable;

/** Drones that stand south of a mission, one beside the other; 0.001 degrees to the north are 111 m. */
final class VirtualFixtures {
    static final Instant NOW = Instant.parse("2026-05-04T10:00:00Z");
    static final Geodetic FIRST = new Geodetic(47.4, 8.5);

    private VirtualFixtures() {}

    /** The same drone, which feels that wind. */
    static DroneState feels(DroneState drone, Wind wind) {
        return new DroneState(
                drone.id(),
                drone.name(),
                drone.replay(),
                drone.link(),
                drone.identification(),
                drone.standing(),
                drone.capabilities(),
                drone.mode(),
                drone.armed(),
                drone.readyToArm(),
                drone.phase(),
                drone.position(),
                drone.local(),
                drone.motion(),
                drone.attitude(),
                drone.battery(),
                drone.gps(),
                drone.home(),
                drone.returnHeight(),
                drone.payload().with(wind),
                drone.mission(),
                drone.messages(),
                drone.lastUpdate(),
                drone.version(),
                null);
    }

    /** What is said of a drone in a test; the rest is as it should be. */
    static final class Drone {
        final DroneId id;
        double metersAway;

        @Nullable
        Integer percent = 90;

        @Nullable
        Double loss = 0.0;

        VehicleKind kind = VehicleKind.MULTICOPTER;
        LinkState link = LinkState.LIVE;

        @Nullable
        Boolean armed = false;

        String mode = "GUIDED";
        boolean airborne;
        boolean ready = true;
        Set<Capability> can = Set.of(Capability.values());
        MissionProgress mission = MissionProgress.UNKNOWN;

        Drone(String id, double metersAway) {
            this.id = new DroneId(id);
            this.metersAway = metersAway;
        }

        Drone carries(VirtualTourSection share, @Nullable Integer current, Integer... reached) {
            mission = new MissionProgress(
                    share.mission().items(), null, current, MissionPhase.RUNNING, List.of(reached), null);
            return this;
        }

        Drone flies() {
            armed = true;
            airborne = true;
            mode = "AUTO";
            return this;
        }

        private LinkStatus link() {
            DroneKey key = new DroneKey("10.9.8.7", 14601, 217);
            return new LinkStatus(key, "udp", link, NOW, new LinkQuality(loss, loss, 20.0), List.of());
        }

        DroneState state() {
            Geodetic stand = new Geodetic(FIRST.latitudeDegrees() - metersAway / 111_195, FIRST.longitudeDegrees());
            return new DroneState(
                    id,
                    "Copter " + id,
                    false,
                    link(),
                    new Identification(kind, "ArduPilot", "ArduCopter", "4.5.6", "cafe01"),
                    IdentityTrust.UNPROVED,
                    new Capabilities(
                            can,
                            List.of("STABILIZE", "GUIDED", "AUTO", "RTL"),
                            Map.of(
                                    "STABILIZE", Steering.STICKS,
                                    "GUIDED", Steering.ORDERS,
                                    "AUTO", Steering.MISSION,
                                    "RTL", Steering.SAFETY)),
                    mode,
                    armed,
                    ready,
                    airborne ? FlightPhase.IN_AIR : FlightPhase.ON_GROUND,
                    new Position(stand, 450.0, airborne ? 20.0 : 0.0),
                    null,
                    null,
                    null,
                    new Battery(percent, null, null),
                    null,
                    new Home(stand, 450),
                    null,
                    PayloadState.UNKNOWN,
                    mission,
                    List.of(),
                    NOW,
                    1,
                    null);
        }
    }

    /** So many waypoints, 100 m apart to the north. */
    static Mission mission(int waypoints) {
        List<MissionItem> items = new ArrayList<>();
        for (int i = 0; i < waypoints; i++) {
            items.add(new MissionItem.Waypoint(
                    new Geodetic(FIRST.latitudeDegrees() + i * 100 / 111_195.0, FIRST.longitudeDegrees()),
                    Altitude.aboveHome(20),
                    0));
        }
        return new Mission(items);
    }

    static VirtualRun asked(int waypoints) {
        return VirtualRun.asked(order(mission(waypoints)), NOW);
    }

    static VirtualRunOrder order(Mission mission) {
        return new VirtualRunOrder(1, mission, MissionCloudLossPolicy.CONTINUE, 1);
    }

    static DroneChoice choiceOf(String drone) {
        return new DroneChoice(new DroneId(drone), null, null, 0, 0, "some 10 %", List.of());
    }

    static VirtualRun bound(int waypoints, String drone) {
        return asked(waypoints).bound(choiceOf(drone), 20.0, NOW);
    }
}
