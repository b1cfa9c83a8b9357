package org.dronemap.proxy.mavlink.translate;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.proxy.mavlink.procedure.Target;

/** Missions to items of the wire and back. */
public final class MissionCodec {
    static final int FRAME_GLOBAL = 0;
    static final int FRAME_RELATIVE = 3;
    static final int NAV_WAYPOINT = 16;
    static final int NAV_RETURN_TO_LAUNCH = 20;
    static final int NAV_LAND = 21;
    static final int NAV_TAKEOFF = 22;
    private static final double E7 = 1e7;

    private MissionCodec() {}

    /** The mission that these items mean, without the home that some autopilots keep in front. */
    public static List<MissionItem> fromWire(List<MissionItemInt> items, int itemsBefore) {
        return items.stream().skip(itemsBefore).map(MissionCodec::fromWire).toList();
    }

    private static MissionItem fromWire(MissionItemInt item) {
        if (item.command() == NAV_RETURN_TO_LAUNCH) {
            return new MissionItem.ReturnToLaunch();
        }
        if (item.command() == NAV_TAKEOFF && isRelative(item)) {
            return new MissionItem.TakeOff(round(item.z()));
        }
        if (item.command() == NAV_LAND && isNowhere(item)) {
            return new MissionItem.Land();
        }
        if (item.command() == NAV_WAYPOINT && isPlace(item)) {
            return new MissionItem.Waypoint(
                    new Geodetic(item.x() / E7, item.y() / E7),
                    new Altitude(round(item.z()), isRelative(item) ? Altitude.Reference.HOME : Altitude.Reference.AMSL),
                    Math.max(0, round(item.param1())));
        }
        return new MissionItem.Other(describe(item, isNowhere(item)));
    }

    private static boolean isRelative(MissionItemInt item) {
        return item.frame() == FRAME_RELATIVE || item.frame() == 6;
    }

    private static boolean isNowhere(MissionItemInt item) {
        return (item.x() == 0 && item.y() == 0) || item.x() == Integer.MAX_VALUE;
    }

    private static boolean isPlace(MissionItemInt item) {
        boolean knownFrame = isRelative(item) || item.frame() == FRAME_GLOBAL || item.frame() == 5;
        boolean onEarth = Math.abs(item.x() / E7) <= 90 && Math.abs(item.y() / E7) <= 180;
        return knownFrame && onEarth && Math.abs(item.z()) <= 10_000;
    }

    private static String describe(MissionItemInt item, boolean nowhere) {
        String what = switch (item.command()) {
            case NAV_WAYPOINT -> "waypoint";
            case 17 -> "loiter without end";
            case 18 -> "loiter turns";
            case 19 -> "loiter for a time";
            case NAV_LAND -> "land";
            case NAV_TAKEOFF -> "take off";
            case 82 -> "spline waypoint";
            case 93 -> "delay";
            case 177 -> "jump";
            case 178 -> "change speed";
            case 201 -> "point the camera";
            case 203 -> "take a photo";
            case 206 -> "take photos by distance";
            default -> "command " + item.command();
        };
        return nowhere
                ? what
                : String.format(Locale.ROOT, "%s at %.6f, %.6f, %.1f m", what, item.x() / E7, item.y() / E7, item.z());
    }

    /** A float's decimals as they were meant: 20.1, not 20.10000038. */
    private static double round(float value) {
        return Float.isNaN(value) ? 0 : Math.round(value * 1000.0) / 1000.0;
    }

    /** What autopilots want in front, and how they write "nothing". */
    record Form(boolean homeInFront, float noYaw, int hereLatitudeE7, int hereLongitudeE7) {}

    static List<MissionItemInt> toWire(List<MissionItem> mission, Target target, VehicleStatus status, Form form) {
        List<MissionItemInt> items = new ArrayList<>();
        if (form.homeInFront()) {
            Double home = status.homeAltitudeAmslMeters();
            items.add(item(
                    target,
                    0,
                    new Step(NAV_WAYPOINT, FRAME_GLOBAL, 0, 0, 0f)
                            .at(status.homeLatitudeE7(), status.homeLongitudeE7(), home == null ? 0 : home)));
        }
        for (MissionItem step : mission) {
            items.add(item(target, items.size(), step(step, form)));
        }
        return items;
    }

    private record Step(int command, int frame, double hold, double altitude, float yaw, int x, int y) {
        Step(int command, int frame, double hold, double altitude, float yaw) {
            this(command, frame, hold, altitude, yaw, 0, 0);
        }

        Step at(int latitudeE7, int longitudeE7, double meters) {
            return new Step(command, frame, hold, meters, yaw, latitudeE7, longitudeE7);
        }
    }

    private static Step step(MissionItem item, Form form) {
        if (item instanceof MissionItem.TakeOff takeOff) {
            return new Step(NAV_TAKEOFF, FRAME_RELATIVE, 0, 0, form.noYaw())
                    .at(form.hereLatitudeE7(), form.hereLongitudeE7(), takeOff.altitudeMeters());
        }
        if (item instanceof MissionItem.Waypoint waypoint) {
            int frame = waypoint.altitude().reference() == Altitude.Reference.HOME ? FRAME_RELATIVE : FRAME_GLOBAL;
            return new Step(NAV_WAYPOINT, frame, waypoint.holdSeconds(), 0, form.noYaw())
                    .at(
                            e7(waypoint.point().latitudeDegrees()),
                            e7(waypoint.point().longitudeDegrees()),
                            waypoint.altitude().meters());
        }
        if (item instanceof MissionItem.Land) {
            return new Step(NAV_LAND, FRAME_RELATIVE, 0, 0, form.noYaw())
                    .at(form.homeInFront() ? 0 : Integer.MAX_VALUE, form.homeInFront() ? 0 : Integer.MAX_VALUE, 0);
        }
        if (item instanceof MissionItem.ReturnToLaunch) {
            return new Step(NAV_RETURN_TO_LAUNCH, FRAME_RELATIVE, 0, 0, 0f);
        }
        throw new IllegalArgumentException("not a plannable mission item: " + item);
    }

    static int e7(double degrees) {
        return (int) Math.round(degrees * E7);
    }

    private static MissionItemInt item(Target target, int seq, Step step) {
        return new MissionItemInt(
                target.systemId(),
                target.componentId(),
                seq,
                step.frame(),
                step.command(),
                0,
                1,
                (float) step.hold(),
                0f,
                0f,
                step.yaw(),
                step.x(),
                step.y(),
                (float) step.altitude(),
                0);
    }
}
