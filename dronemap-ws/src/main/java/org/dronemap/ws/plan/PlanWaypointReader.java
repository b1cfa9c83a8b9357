package org.dronemap.ws.plan;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.Skill;
import org.dronemap.cognitive.problem.Task;
import org.dronemap.cognitive.problem.TimeWindow;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.WaypointTask;
import org.dronemap.ws.mission.MissionReader;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.FieldRanges;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/**
 * Turns the waypoints that a client wrote for a plan into those of the planning problem, or rejects the faulty field.
 */
public final class PlanWaypointReader {
    static final int MOST = 5_000;
    private static final String COUNT = "1 to " + MOST + " waypoints";
    static final int LONGEST_ID = 40;
    private static final String ID_FORM = "1 to " + LONGEST_ID + " printable characters";
    private static final String CAPABILITIES =
            Arrays.stream(Capability.values()).map(WireNames::camel).collect(Collectors.joining(", "));
    /** Homes farther apart in height make "above home" mean too different things. */
    private static final double MOST_BETWEEN_HOMES_METERS = 20;

    static final int LONGEST_WINDOW_SECONDS = 86_400;
    private static final double USUAL_PRIORITY = 1;

    private final List<Craft> crafts;

    /** {@code crafts}: above whose homes altitudes may be counted. */
    public PlanWaypointReader(List<Craft> crafts) {
        this.crafts = crafts;
    }

    public List<Waypoint> read(@Nullable List<PlanRequest.@Nullable WaypointRequest> asked) {
        if (asked == null || asked.isEmpty()) {
            throw InvalidInput.missing("waypoints", COUNT);
        }
        if (asked.size() > MOST) {
            throw InvalidInput.outside(
                    ValueProblem.SIZE_OUT_OF_RANGE,
                    "waypoints",
                    COUNT,
                    asked.size(),
                    ProblemParameter.LEAST.is(1),
                    ProblemParameter.MOST.is(MOST));
        }
        Set<String> ids = new HashSet<>();
        List<Waypoint> read = new ArrayList<>(asked.size());
        for (int index = 0; index < asked.size(); index++) {
            String at = "waypoints[" + index + "]";
            PlanRequest.WaypointRequest one = asked.get(index);
            if (one == null) {
                throw InvalidInput.missing(at, "a waypoint");
            }
            Waypoint waypoint = waypoint(at + ".", one, index + 1);
            if (!ids.add(waypoint.id())) {
                throw new InvalidInput(
                        ValueProblem.VALUE_NOT_UNIQUE,
                        at + ".id",
                        "another one each",
                        "Two waypoints are called \"" + waypoint.id() + "\".");
            }
            read.add(waypoint);
        }
        return read;
    }

    private Waypoint waypoint(String at, PlanRequest.WaypointRequest asked, int number) {
        Geodetic point = new Geodetic(
                FieldRanges.latitude(at + "latitude", asked.latitude()),
                FieldRanges.longitude(at + "longitude", asked.longitude()));
        return new Waypoint(
                id(at, asked.id(), number),
                new Place(point, amslMeters(at, asked.altitude(), asked.altitudeReference())),
                task(at, asked),
                priority(at, asked.priority()),
                window(at + "window.", asked.window()));
    }

    /** What is waited beside comes after all that is done. */
    private Task task(String at, PlanRequest.WaypointRequest asked) {
        Double hold = asked.holdSeconds();
        double seconds = hold == null ? 0 : FieldRanges.holdSeconds(at + "holdSeconds", hold);
        Set<Skill> needs = new HashSet<>(needs(at, asked.needs()));
        List<WaypointTask> parts = PlanTaskRequest.read(
                at + "tasks", asked.tasks(), meters -> amslMeters(at, meters, asked.altitudeReference()));
        if (parts.stream().anyMatch(WaypointTask.Photo.class::isInstance)) {
            needs.add(Skill.of(Capability.TAKE_PICTURE));
        }
        return new Task(
                seconds + parts.stream().mapToDouble(WaypointTask::seconds).sum(), needs, parts);
    }

    private static String id(String at, @Nullable String given, int number) {
        if (given == null) {
            return String.valueOf(number);
        }
        if (given.isBlank() || given.length() > LONGEST_ID || given.chars().anyMatch(Character::isISOControl)) {
            throw InvalidInput.outside(ValueProblem.VALUE_MALFORMED, at + "id", ID_FORM, "\"" + given.strip() + "\"");
        }
        return given;
    }

    public double amslMeters(String at, @Nullable Double asked, @Nullable String reference) {
        Altitude altitude = MissionReader.altitude(at, asked, reference);
        double meters = altitude.reference() == Altitude.Reference.AMSL
                ? altitude.meters()
                : altitude.meters() + highestHomeMeters(at);
        return FieldRanges.altitude(at + "altitude", meters);
    }

    /** The highest, so that no drone flies lower above its own home than was asked for. */
    private double highestHomeMeters(String at) {
        double highest = crafts.stream()
                .mapToDouble(Craft::homeAmslMeters)
                .max()
                .orElseThrow(() -> InvalidInput.missing("drones", PlanReader.DRONES_FORM));
        double lowest = crafts.stream().mapToDouble(Craft::homeAmslMeters).min().orElse(highest);
        if (highest - lowest > MOST_BETWEEN_HOMES_METERS) {
            throw new InvalidInput(
                    ValueProblem.ALTITUDE_AMBIGUOUS,
                    at + "altitudeReference",
                    "amsl",
                    "The homes of these drones differ by " + Math.round(highest - lowest)
                            + " m in height, so above which home is meant is not known; give altitudes above sea level.");
        }
        return highest;
    }

    private static Set<Skill> needs(String at, @Nullable List<@Nullable String> names) {
        Set<Skill> needs = new HashSet<>();
        for (int index = 0; names != null && index < names.size(); index++) {
            String name = String.valueOf(names.get(index));
            String field = at + "needs[" + index + "]";
            needs.add(Skill.of(Arrays.stream(Capability.values())
                    .filter(one -> WireNames.camel(one).equals(name))
                    .findFirst()
                    .orElseThrow(() -> InvalidInput.outside(
                            ValueProblem.VALUE_NOT_ALLOWED, field, CAPABILITIES, "\"" + name + "\""))));
        }
        return needs;
    }

    private static double priority(String at, @Nullable Double given) {
        if (given == null) {
            return USUAL_PRIORITY;
        }
        if (!(given >= Waypoint.LEAST_PRIORITY && given <= Waypoint.HIGHEST_PRIORITY)) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_OUT_OF_RANGE,
                    at + "priority",
                    "0.001 to 1000",
                    given,
                    ProblemParameter.LEAST.is(0.001),
                    ProblemParameter.MOST.is(1000));
        }
        return given;
    }

    private static TimeWindow window(String at, PlanRequest.@Nullable WindowRequest asked) {
        if (asked == null) {
            return TimeWindow.ALWAYS;
        }
        Double opens = asked.opens();
        Double closes = asked.closes();
        double begin =
                opens == null ? 0 : FieldRanges.checked(at + "opens", opens, 0, LONGEST_WINDOW_SECONDS, "seconds");
        if (closes == null) {
            return new TimeWindow(begin, Double.POSITIVE_INFINITY);
        }
        double end = FieldRanges.checked(at + "closes", closes, 0, LONGEST_WINDOW_SECONDS, "seconds");
        if (end < begin) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_OUT_OF_RANGE,
                    at + "closes",
                    "at or after the opening (" + begin + " s)",
                    end,
                    ProblemParameter.LEAST.is(begin),
                    ProblemParameter.UNIT.is("s"));
        }
        return new TimeWindow(begin, end);
    }
}
