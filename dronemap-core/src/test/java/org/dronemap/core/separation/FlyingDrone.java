package org.dronemap.core.separation;

import java.time.Duration;
import java.time.Instant;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
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
import org.dronemap.core.drone.Motion;
import org.dronemap.core.drone.PayloadState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.jspecify.annotations.Nullable;

/** A drone of the tests in the picture of the airspace; places are metres east and north of a point, heights above home. */
final class FlyingDrone {
    static final Instant NOW = Instant.parse("2026-05-04T10:00:00Z");
    static final double GROUND = 450;
    private static final LocalPlane PLANE = new LocalPlane(new Geodetic(47.4, 8.5));

    final DroneId id;
    double east;
    double north;
    double height = 20;
    double homeEast;
    double homeNorth;
    double homeAmsl = GROUND;
    double eastward;
    double northward;
    double climbing;
    String mode = "AUTO";
    boolean airborne = true;
    boolean armed = true;
    LinkState link = LinkState.LIVE;
    Duration silence = Duration.ZERO;
    Handling handling = Handling.COMMANDED;
    FlightIntent.@Nullable Step step = FlightIntent.Step.FLY;
    boolean commanded;
    boolean goesOnAlone;
    List<MissionItem> ahead = List.of();

    @Nullable
    String operation;

    FlyingDrone(String id, double east, double north) {
        this.id = new DroneId(id);
        this.operation = id;
        this.east = east;
        this.north = north;
        this.homeEast = east;
        this.homeNorth = north;
    }

    static Geodetic point(double east, double north) {
        return PLANE.place(new PlanePoint(east, north));
    }

    /** On its way there at 8 m/s. */
    FlyingDrone to(double toEast, double toNorth, double toHeight) {
        ahead = List.of(new MissionItem.Waypoint(
                point(toEast, toNorth), new Altitude(GROUND + toHeight, Altitude.Reference.AMSL), 0));
        double meters = Math.hypot(toEast - east, toNorth - north);
        eastward = meters == 0 ? 0 : 8 * (toEast - east) / meters;
        northward = meters == 0 ? 0 : 8 * (toNorth - north) / meters;
        return this;
    }

    FlyingDrone stands(String how) {
        mode = how;
        eastward = 0;
        northward = 0;
        step = FlightIntent.Step.STAND;
        return this;
    }

    /** On its pad, about to fly that mission. */
    FlyingDrone risesTo(double toEast, double toNorth, double toHeight) {
        to(toEast, toNorth, toHeight);
        List<MissionItem> items = List.of(new MissionItem.TakeOff(toHeight), ahead.get(0));
        ahead = items;
        eastward = 0;
        northward = 0;
        height = 0;
        airborne = false;
        armed = false;
        mode = "GUIDED";
        step = FlightIntent.Step.RISE;
        return this;
    }

    FlyingDrone byHand() {
        handling = Handling.FOREIGN;
        mode = "LOITER";
        step = null;
        operation = null;
        return this;
    }

    TrackedDrone seen() {
        FlightIntent intent = step == null
                ? null
                : new FlightIntent(step, ahead, null, commanded, NOW.minusSeconds(1)).goingOnAlone(goesOnAlone);
        return new TrackedDrone(
                state(),
                silence,
                intent,
                handling,
                operation,
                new GroundVelocity(eastward, northward),
                new FlightPace(8, 2.5, 1.5, 2.5));
    }

    private DroneState state() {
        return new DroneState(
                id,
                "Copter " + id,
                false,
                new LinkStatus(new DroneKey("10.9.8.7", 14601, 1), "udp", link, NOW, LinkQuality.UNKNOWN, List.of()),
                new Identification(VehicleKind.MULTICOPTER, "ArduPilot", "ArduCopter", "4.5.6", "cafe01"),
                IdentityTrust.UNPROVED,
                new Capabilities(
                        EnumSet.allOf(Capability.class),
                        List.of("LOITER", "GUIDED", "AUTO", "RTL"),
                        Map.of(
                                "LOITER", Steering.STICKS,
                                "GUIDED", Steering.ORDERS,
                                "AUTO", Steering.MISSION,
                                "RTL", Steering.HOME)),
                mode,
                armed,
                true,
                airborne ? FlightPhase.IN_AIR : FlightPhase.ON_GROUND,
                new Position(point(east, north), homeAmsl + height, height),
                null,
                new Motion(Math.hypot(eastward, northward), null, climbing, null),
                null,
                null,
                null,
                new Home(point(homeEast, homeNorth), homeAmsl),
                null,
                PayloadState.UNKNOWN,
                new MissionProgress(ahead, null, 0, MissionPhase.RUNNING, List.of(), null),
                List.of(),
                NOW,
                1,
                null);
    }
}
