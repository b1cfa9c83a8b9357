package org.dronemap.ws.mission;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.LandingPlace;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.FieldRanges;
import org.jspecify.annotations.Nullable;

/** Turns the items that a client wrote into a mission, or says which member of which item is wrong. */
public final class MissionReader {
    private static final String COUNT = "1 to " + Mission.MAX_ITEMS + " items";
    private static final String REFERENCES = "home or amsl";

    private MissionReader() {}

    public static Mission read(@Nullable List<MissionItemRequest> items) {
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
            read.add(items.get(index).read("items[" + index + "]."));
        }
        return new Mission(read);
    }

    public static MissionItem.SetServo servo(String at, @Nullable Integer output, @Nullable Integer pulse) {
        return new MissionItem.SetServo(
                FieldRanges.output(at + "output", output), FieldRanges.pulse(at + "pulse", pulse));
    }

    /** Null where no member says one; all of it or nothing. */
    static @Nullable LandingPlace landingPlace(String at, MissionItemRequest.Land land) {
        boolean here = land.latitude() == null
                && land.longitude() == null
                && land.altitude() == null
                && land.altitudeReference() == null;
        return here
                ? null
                : new LandingPlace(
                        FieldRanges.point(at, land.latitude(), land.longitude()),
                        altitude(at, land.altitude() == null ? 0.0 : land.altitude(), land.altitudeReference()));
    }

    /** {@code at} is what stands before the field's name, such as {@code items[2].}. */
    public static Altitude altitude(String at, @Nullable Double meters, @Nullable String reference) {
        double checked = FieldRanges.altitude(at + "altitude", meters);
        return switch (reference == null ? "home" : reference) {
            case "home" -> new Altitude(checked, Altitude.Reference.HOME);
            case "amsl" -> new Altitude(checked, Altitude.Reference.AMSL);
            default ->
                throw InvalidInput.outside(
                        ValueProblem.VALUE_NOT_ALLOWED, at + "altitudeReference", REFERENCES, "\"" + reference + "\"");
        };
    }
}
