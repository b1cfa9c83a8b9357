package org.dronemap.core.safety;

import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.dronemap.core.command.ChangeSpeed;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.LinkTrend;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.jspecify.annotations.Nullable;

/**
 * Chooses what a flying drone that nobody has in hand does before its link is lost: climb or slow down where that may help
 * and is allowed, else come home. Pure.
 */
public final class LinkActPlanner {
    /** With less time left nothing is tried. */
    private static final int LAST_SECONDS = 15;

    private static final double LEAST_CLIMB_METERS = 10;
    private static final double USUAL_CLIMB_METERS = 20;
    private static final double CLIMBED_SHARE = 0.5;
    /** Higher than this above home drones are not flown without a permit. */
    private static final double CEILING_METERS = 120;
    /** Nearer to home than this, the antennas see each other: height is not what is missing. */
    private static final double NEAR_METERS = 100;

    private static final double QUICK = 4;
    private static final double SLOWEST = 2;

    private static final Set<VehicleKind> HOVERING = Set.of(VehicleKind.MULTICOPTER, VehicleKind.HELICOPTER);

    /** Check of a way against zones; empty: no objection. */
    public interface WayCheck {
        Optional<String> against(Command.GoTo way);
    }

    private LinkActPlanner() {}

    static LinkAct first(DroneState drone, boolean inMission, WayCheck zones) {
        LinkTrend trend = drone.link().trend();
        Integer left = trend.secondsLeft();
        if (left == null || left > LAST_SECONDS) {
            Optional<LinkAct> climb = climb(drone, zones);
            if (climb.isPresent()) {
                return climb.get();
            }
            Optional<LinkAct> slower = slower(drone, inMission);
            if (slower.isPresent()) {
                return slower.get();
            }
        }
        return LinkAct.comeHome(trend.words() + " It comes home before that.");
    }

    private static Optional<LinkAct> climb(DroneState drone, WayCheck zones) {
        Position position = drone.position();
        Geodetic here = position == null ? null : position.point();
        Double above = position == null ? null : position.altitudeAboveHomeMeters();
        if (here == null || above == null || !hovers(drone) || !can(drone, Capability.GO_TO) || isNear(drone, here)) {
            return Optional.empty();
        }
        double height = Math.min(CEILING_METERS, above + Math.max(USUAL_CLIMB_METERS, above * CLIMBED_SHARE));
        Command.GoTo up = new Command.GoTo(here, Altitude.aboveHome(height));
        return height - above < LEAST_CLIMB_METERS || zones.against(up).isPresent()
                ? Optional.empty()
                : Optional.of(LinkAct.climb(
                        up,
                        String.format(
                                Locale.ROOT,
                                "%s It climbs to %.0f m: a higher antenna sees farther.",
                                drone.link().trend().words(),
                                height)));
    }

    private static boolean isNear(DroneState drone, Geodetic here) {
        Home home = drone.home();
        return home != null && Geodesy.distanceMeters(here, home.point()) < NEAR_METERS;
    }

    private static Optional<LinkAct> slower(DroneState drone, boolean inMission) {
        Double speed = speed(drone);
        if (!inMission || speed == null || speed < QUICK || !hovers(drone) || !can(drone, Capability.CHANGE_SPEED)) {
            return Optional.empty();
        }
        double slow = Math.max(SLOWEST, speed / 2);
        return Optional.of(LinkAct.slowDown(
                new ChangeSpeed(slow),
                String.format(
                        Locale.ROOT,
                        "%s It slows down to %.0f m/s, and cannot climb here.",
                        drone.link().trend().words(),
                        slow)));
    }

    static @Nullable Double speed(DroneState drone) {
        Motion motion = drone.motion();
        return motion == null ? null : motion.groundSpeed();
    }

    private static boolean hovers(DroneState drone) {
        return HOVERING.contains(drone.identification().kind());
    }

    private static boolean can(DroneState drone, Capability capability) {
        return drone.capabilities().commands().contains(capability);
    }
}
