package org.dronemap.proxy.mavlink.translate;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.LandingPlace;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.proxy.mavlink.procedure.MavlinkTarget;
import org.jspecify.annotations.Nullable;

/** Converts missions between the cloud's model and MAVLink mission items. */
public final class MissionCodec {
    static final int FRAME_GLOBAL = 0;
    static final int FRAME_RELATIVE = 3;
    static final int NAV_WAYPOINT = 16;
    static final int NAV_RETURN_TO_LAUNCH = 20;
    static final int NAV_LAND = 21;
    static final int NAV_TAKEOFF = 22;
    static final int NAV_VTOL_LAND = 85;
    static final int NAV_DELAY = 93;
    static final int DO_LAND_START = 189;
    private static final int DO_CHANGE_SPEED = 178;
    static final int DO_SET_SERVO = 183;
    static final int DO_SET_ROI_LOCATION = 195;
    static final int DO_SET_ROI_NONE = 197;
    /** The older one for both of these: with a place to look at, or without one. */
    static final int DO_SET_ROI = 201;

    static final int DO_DIGICAM_CONTROL = 203;
    static final int IMAGE_START_CAPTURE = 2000;
    private static final int FRAME_MISSION = 2;
    private static final int ONE_PHOTO = 1;
    private static final int ROI_NONE = 0;
    static final int ROI_PLACE = 3;
    /** Degrees up; where a mission says nothing, planes climb by 4 degrees and may not clear what is ahead. */
    static final int TAKE_OFF_PITCH = 15;

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
        if (isLanding(item) && (isNowhere(item) || isPlace(item))) {
            return new MissionItem.Land(isNowhere(item) ? null : new LandingPlace(point(item), altitude(item)));
        }
        if (item.command() == NAV_WAYPOINT && isPlace(item)) {
            return new MissionItem.Waypoint(point(item), altitude(item), Math.max(0, round(item.param1())));
        }
        return orders(item).orElseGet(() -> new MissionItem.Other(describe(item, isNowhere(item))));
    }

    /** What is done where it is. */
    private static Optional<MissionItem> orders(MissionItemInt item) {
        return Optional.ofNullable(
                switch (item.command()) {
                    // Without seconds it waits for a time of day.
                    case NAV_DELAY -> item.param1() > 0 ? new MissionItem.Wait(round(item.param1())) : null;
                    case DO_SET_SERVO -> servo(item);
                    case DO_SET_ROI_LOCATION ->
                        isPlace(item) ? new MissionItem.LookAt(point(item), altitude(item)) : null;
                    case DO_SET_ROI_NONE -> new MissionItem.LookAhead();
                    case DO_SET_ROI -> look(item);
                    case DO_DIGICAM_CONTROL -> item.x() == ONE_PHOTO ? new MissionItem.TakePhoto() : null;
                    case IMAGE_START_CAPTURE -> item.param3() == 1 ? new MissionItem.TakePhoto() : null;
                    default -> null;
                });
    }

    private static @Nullable MissionItem servo(MissionItemInt item) {
        int output = Math.round(item.param1());
        int pulse = Math.round(item.param2());
        boolean known = output >= 1
                && output <= MissionItem.SetServo.MOST_OUTPUTS
                && pulse >= MissionItem.SetServo.SHORTEST_MICROS
                && pulse <= MissionItem.SetServo.LONGEST_MICROS;
        return known ? new MissionItem.SetServo(output, pulse) : null;
    }

    /** The next waypoint, or another vehicle, may be looked at as well; not by the cloud. */
    private static @Nullable MissionItem look(MissionItemInt item) {
        if (item.param1() != ROI_NONE && item.param1() != ROI_PLACE) {
            return null;
        }
        if (isNowhere(item) && item.z() == 0) {
            return new MissionItem.LookAhead();
        }
        return isPlace(item) ? new MissionItem.LookAt(point(item), altitude(item)) : null;
    }

    static boolean isLanding(MissionItemInt item) {
        return item.command() == NAV_LAND || item.command() == NAV_VTOL_LAND;
    }

    private static Geodetic point(MissionItemInt item) {
        return new Geodetic(item.x() / E7, item.y() / E7);
    }

    private static Altitude altitude(MissionItemInt item) {
        return new Altitude(round(item.z()), isRelative(item) ? Altitude.Reference.HOME : Altitude.Reference.AMSL);
    }

    /** Whether it has a part by which a fixed wing lands: a mark where that begins, and a landing after it. */
    public static boolean hasLandingSequence(List<MissionItemInt> items) {
        return items.stream().dropWhile(item -> item.command() != DO_LAND_START).anyMatch(MissionCodec::isLanding);
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
            case DO_CHANGE_SPEED -> speed(item);
            case DO_SET_SERVO -> "set a servo";
            case DO_LAND_START -> "begin of the landing sequence";
            case DO_SET_ROI -> "point the camera";
            case DO_DIGICAM_CONTROL, IMAGE_START_CAPTURE -> "control the camera";
            case 206 -> "take photos by distance";
            default -> "command " + item.command();
        };
        return nowhere
                ? what
                : String.format(
                        Locale.ROOT,
                        "%s at %.6f, %.6f, %.1f m %s",
                        what,
                        item.x() / E7,
                        item.y() / E7,
                        item.z(),
                        above(item.frame()));
    }

    private static String above(int frame) {
        return FenceCodec.reference(frame)
                .map(reference -> switch (reference) {
                    case HOME -> "above home";
                    case AMSL -> "above sea level";
                    case TERRAIN -> "above the ground";
                })
                .orElse("in frame " + frame);
    }

    /** A speed of nothing or less leaves it as it is. */
    private static String speed(MissionItemInt item) {
        return item.param2() > 0
                ? String.format(Locale.ROOT, "change speed to %.1f m/s", item.param2())
                : "change speed";
    }

    /** A float's decimals as they were meant: 20.1, not 20.10000038. */
    private static double round(float value) {
        return Float.isNaN(value) ? 0 : Math.round(value * 1000.0) / 1000.0;
    }

    /** The form of a mission on the wire: whether home comes first, and how "nothing" is written. */
    record Form(boolean homeInFront, float noYaw, int hereLatitudeE7, int hereLongitudeE7, VehicleKind kind) {
        /** ArduPilot's missions know the older item alone, in every version. */
        boolean looksByOneItem() {
            return homeInFront;
        }

        double takeOffPitch() {
            return homeInFront && kind == VehicleKind.FIXED_WING ? TAKE_OFF_PITCH : 0;
        }

        int landing() {
            return kind == VehicleKind.VTOL ? NAV_VTOL_LAND : NAV_LAND;
        }
    }

    static List<MissionItemInt> toWire(
            List<MissionItem> mission, MavlinkTarget target, VehicleStatus status, Form form) {
        List<MissionItemInt> items = new ArrayList<>();
        if (form.homeInFront()) {
            Double home = status.homeAltitudeAmslMeters();
            items.add(item(
                    target,
                    0,
                    new Step(NAV_WAYPOINT, FRAME_GLOBAL, 0, 0f)
                            .at(status.homeLatitudeE7(), status.homeLongitudeE7(), home == null ? 0 : home)));
        }
        for (MissionItem step : mission) {
            items.add(item(target, items.size(), step(step, form)));
        }
        return items;
    }

    private record Step(int command, int frame, double first, double second, float yaw, Spot spot) {
        /** The place of an item in wire units; 0, 0 also where it has none. */
        record Spot(int x, int y, double altitude) {
            static final Spot NONE = new Spot(0, 0, 0);
        }

        Step(int command, int frame, double first, float yaw) {
            this(command, frame, first, 0, yaw, Spot.NONE);
        }

        /** Without a place. */
        static Step order(int command, double first, double second) {
            return new Step(command, FRAME_MISSION, first, second, 0f, Spot.NONE);
        }

        Step at(int latitudeE7, int longitudeE7, double meters) {
            return new Step(command, frame, first, second, yaw, new Spot(latitudeE7, longitudeE7, meters));
        }

        Step at(Geodetic point, Altitude altitude) {
            return at(e7(point.latitudeDegrees()), e7(point.longitudeDegrees()), altitude.meters());
        }
    }

    private static Step step(MissionItem item, Form form) {
        return switch (item.kind()) {
            case TAKE_OFF ->
                new Step(NAV_TAKEOFF, FRAME_RELATIVE, form.takeOffPitch(), form.noYaw())
                        .at(
                                form.hereLatitudeE7(),
                                form.hereLongitudeE7(),
                                ((MissionItem.TakeOff) item).altitudeMeters());
            case WAYPOINT -> waypoint((MissionItem.Waypoint) item, form);
            case LAND -> land(((MissionItem.Land) item).place(), form);
            case RETURN_TO_LAUNCH -> new Step(NAV_RETURN_TO_LAUNCH, FRAME_RELATIVE, 0, 0f);
            case WAIT -> Step.order(NAV_DELAY, ((MissionItem.Wait) item).seconds(), 0);
            case TAKE_PHOTO -> Step.order(DO_DIGICAM_CONTROL, 0, 0).at(ONE_PHOTO, 0, 0);
            case SET_SERVO ->
                Step.order(
                        DO_SET_SERVO,
                        ((MissionItem.SetServo) item).output(),
                        ((MissionItem.SetServo) item).pulseMicros());
            case LOOK_AT -> look((MissionItem.LookAt) item, form);
            case LOOK_AHEAD ->
                form.looksByOneItem()
                        ? new Step(DO_SET_ROI, FRAME_RELATIVE, ROI_NONE, 0f)
                        : Step.order(DO_SET_ROI_NONE, 0, 0);
            case OTHER -> throw new IllegalArgumentException("not a plannable mission item: " + item);
        };
    }

    private static Step waypoint(MissionItem.Waypoint waypoint, Form form) {
        return new Step(NAV_WAYPOINT, frame(waypoint.altitude()), waypoint.holdSeconds(), form.noYaw())
                .at(waypoint.point(), waypoint.altitude());
    }

    private static Step land(@Nullable LandingPlace place, Form form) {
        if (place != null) {
            return new Step(form.landing(), frame(place.ground()), 0, form.noYaw()).at(place.point(), place.ground());
        }
        int here = form.homeInFront() ? 0 : Integer.MAX_VALUE;
        return new Step(form.landing(), FRAME_RELATIVE, 0, form.noYaw()).at(here, here, 0);
    }

    private static Step look(MissionItem.LookAt look, Form form) {
        return new Step(
                        form.looksByOneItem() ? DO_SET_ROI : DO_SET_ROI_LOCATION,
                        frame(look.altitude()),
                        form.looksByOneItem() ? ROI_PLACE : 0,
                        0f)
                .at(look.point(), look.altitude());
    }

    private static int frame(Altitude altitude) {
        return altitude.reference() == Altitude.Reference.HOME ? FRAME_RELATIVE : FRAME_GLOBAL;
    }

    static int e7(double degrees) {
        return (int) Math.round(degrees * E7);
    }

    private static MissionItemInt item(MavlinkTarget target, int seq, Step step) {
        return new MissionItemInt(
                target.systemId(),
                target.componentId(),
                seq,
                step.frame(),
                step.command(),
                0,
                1,
                (float) step.first(),
                (float) step.second(),
                0f,
                step.yaw(),
                step.spot().x(),
                step.spot().y(),
                (float) step.spot().altitude(),
                0);
    }
}
