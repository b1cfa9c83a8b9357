package org.dronemap.ws.service;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.mission.WaypointTask;
import org.jspecify.annotations.Nullable;

/** Turns what a client wants done at a waypoint into its tasks, or says which member of which one is wrong. */
final class PlanTasks {
    private static final int MOST = 10;
    private static final String COUNT = "up to " + MOST + " tasks";
    private static final String TYPES = "photo, servo, lookAt or readSensors";
    private static final double USUAL_SECONDS = 5;

    private final ToDoubleFunction<@Nullable Double> amslMeters;

    /** {@code amslMeters}: what an altitude as written means above the sea. */
    PlanTasks(ToDoubleFunction<@Nullable Double> amslMeters) {
        this.amslMeters = amslMeters;
    }

    List<WaypointTask> read(String at, @Nullable List<PlanRequest.@Nullable TaskRequest> asked) {
        if (asked == null) {
            return List.of();
        }
        if (asked.size() > MOST) {
            throw InvalidInput.outside(
                    ValueProblem.SIZE_OUT_OF_RANGE, at, COUNT, asked.size(), ProblemParameter.MOST.is(MOST));
        }
        List<WaypointTask> tasks = new ArrayList<>();
        for (int index = 0; index < asked.size(); index++) {
            tasks.add(task(at + "[" + index + "]", asked.get(index)));
        }
        return tasks;
    }

    private WaypointTask task(String at, PlanRequest.@Nullable TaskRequest asked) {
        String type = asked == null ? null : asked.type();
        if (asked == null || type == null) {
            throw InvalidInput.missing(at + ".type", TYPES);
        }
        return switch (type) {
            case "photo" -> new WaypointTask.Photo();
            case "servo" -> {
                MissionItem.SetServo servo = MissionReader.servo(at + ".", asked.output(), asked.pulse());
                yield new WaypointTask.Servo(servo.output(), servo.pulseMicros());
            }
            case "lookAt" ->
                new WaypointTask.Look(
                        new Geodetic(
                                Ranges.latitude(at + ".latitude", asked.latitude()),
                                Ranges.longitude(at + ".longitude", asked.longitude())),
                        amsl(at, asked.altitude()));
            case "readSensors" ->
                new WaypointTask.Sensors(Ranges.checked(
                        at + ".seconds",
                        asked.seconds() == null ? Double.valueOf(USUAL_SECONDS) : asked.seconds(),
                        1,
                        3600,
                        "seconds"));
            default ->
                throw InvalidInput.outside(ValueProblem.VALUE_NOT_ALLOWED, at + ".type", TYPES, "\"" + type + "\"");
        };
    }

    private double amsl(String at, @Nullable Double altitude) {
        Ranges.altitude(at + ".altitude", altitude);
        return amslMeters.applyAsDouble(altitude);
    }
}
