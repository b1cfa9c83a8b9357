package org.dronemap.ws.service;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.jspecify.annotations.Nullable;

/** Turns the items that a client wrote into a mission, or says which member of which item is wrong. */
final class MissionReader {
    private static final String COUNT = "1 to " + Mission.MAX_ITEMS + " items";
    private static final String TYPES =
            "takeOff, waypoint, returnToLaunch, land, wait, takePhoto, setServo, lookAt or lookAhead";
    private static final String REFERENCES = "home or amsl";

    private MissionReader() {}

    static Mission read(@Nullable List<MissionItemView> items) {
        if (items == null || items.isEmpty()) {
            throw InvalidInput.missing("items", COUNT);
        }
        if (items.size() > Mission.MAX_ITEMS) {
            throw InvalidInput.outside(
                    ValueProblem.SIZE_OUT_OF_RANGE,
                    "items",
                    COUNT,
                    items.size(),
                    ProblemParameter.LEAST.is(1),
                    ProblemParameter.MOST.is(Mission.MAX_ITEMS));
        }
        List<MissionItem> read = new ArrayList<>(items.size());
        for (int index = 0; index < items.size(); index++) {
            read.add(item("items[" + index + "]", items.get(index)));
        }
        return new Mission(read);
    }

    private static MissionItem item(String at, @Nullable MissionItemView item) {
        if (item == null || item.type() == null) {
            throw InvalidInput.missing(at + ".type", TYPES);
        }
        String type = item.type();
        return switch (MissionItem.Kind.named(type).orElse(MissionItem.Kind.OTHER)) {
            case TAKE_OFF -> new MissionItem.TakeOff(Ranges.takeOffAltitude(at + ".altitude", item.altitude()));
            case WAYPOINT -> waypoint(at + ".", item);
            case RETURN_TO_LAUNCH -> new MissionItem.ReturnToLaunch();
            case LAND -> new MissionItem.Land();
            case WAIT -> new MissionItem.Wait(Ranges.waitSeconds(at + ".holdSeconds", item.holdSeconds()));
            case TAKE_PHOTO -> new MissionItem.TakePhoto();
            case SET_SERVO -> servo(at + ".", item.output(), item.pulse());
            case LOOK_AT -> lookAt(at + ".", item);
            case LOOK_AHEAD -> new MissionItem.LookAhead();
            case OTHER ->
                throw InvalidInput.outside(ValueProblem.VALUE_NOT_ALLOWED, at + ".type", TYPES, "\"" + type + "\"");
        };
    }

    private static MissionItem.Waypoint waypoint(String at, MissionItemView item) {
        Geodetic point = new Geodetic(
                Ranges.latitude(at + "latitude", item.latitude()),
                Ranges.longitude(at + "longitude", item.longitude()));
        Double hold = item.holdSeconds();
        return new MissionItem.Waypoint(
                point,
                altitude(at, item.altitude(), item.altitudeReference()),
                hold == null ? 0 : Ranges.holdSeconds(at + "holdSeconds", hold));
    }

    static MissionItem.SetServo servo(String at, @Nullable Integer output, @Nullable Integer pulse) {
        return new MissionItem.SetServo(Ranges.output(at + "output", output), Ranges.pulse(at + "pulse", pulse));
    }

    private static MissionItem.LookAt lookAt(String at, MissionItemView item) {
        Geodetic point = new Geodetic(
                Ranges.latitude(at + "latitude", item.latitude()),
                Ranges.longitude(at + "longitude", item.longitude()));
        return new MissionItem.LookAt(point, altitude(at, item.altitude(), item.altitudeReference()));
    }

    /** {@code at} is what stands before the field's name, such as {@code items[2].}. */
    static Altitude altitude(String at, @Nullable Double meters, @Nullable String reference) {
        double checked = Ranges.altitude(at + "altitude", meters);
        return switch (reference == null ? "home" : reference) {
            case "home" -> new Altitude(checked, Altitude.Reference.HOME);
            case "amsl" -> new Altitude(checked, Altitude.Reference.AMSL);
            default ->
                throw InvalidInput.outside(
                        ValueProblem.VALUE_NOT_ALLOWED, at + "altitudeReference", REFERENCES, "\"" + reference + "\"");
        };
    }
}
