package org.dronemap.ws.plan;

import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.mission.WaypointTask;
import org.dronemap.ws.mission.MissionReader;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.FieldRanges;
import org.dronemap.ws.reading.ObjectOnlyTypeResolver;
import org.dronemap.ws.reading.RecordAlternatives;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.annotation.JsonTypeResolver;

/** A task to be done at a waypoint of a plan, such as taking a photo, as a client writes it. */
@JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "type")
@JsonTypeResolver(ObjectOnlyTypeResolver.class)
@JsonSubTypes({
    @JsonSubTypes.Type(value = PlanTaskRequest.Photo.class, name = "photo"),
    @JsonSubTypes.Type(value = PlanTaskRequest.Servo.class, name = "servo"),
    @JsonSubTypes.Type(value = PlanTaskRequest.LookAt.class, name = "lookAt"),
    @JsonSubTypes.Type(value = PlanTaskRequest.ReadSensors.class, name = "readSensors")
})
@Schema(
        name = "PlanTaskRequest",
        description = "Something that is done at a waypoint; which members there are depends on the type.")
public sealed interface PlanTaskRequest {
    /** More are not done at one waypoint. */
    int MOST = 10;

    /**
     * The planner's tasks, or a refusal of the faulty field.
     *
     * @param amslMeters what an altitude as written means above the sea
     */
    static List<WaypointTask> read(
            String at, @Nullable List<@Nullable PlanTaskRequest> asked, ToDoubleFunction<@Nullable Double> amslMeters) {
        if (asked == null) {
            return List.of();
        }
        if (asked.size() > MOST) {
            throw InvalidInput.outside(
                    ValueProblem.SIZE_OUT_OF_RANGE,
                    at,
                    "up to " + MOST + " tasks",
                    asked.size(),
                    ProblemParameter.MOST.is(MOST));
        }
        List<WaypointTask> tasks = new ArrayList<>();
        for (int index = 0; index < asked.size(); index++) {
            String field = at + "[" + index + "].";
            PlanTaskRequest task = asked.get(index);
            if (task == null) {
                throw InvalidInput.missing(
                        field + "type",
                        RecordAlternatives.of(PlanTaskRequest.class)
                                .orElseThrow()
                                .allowed());
            }
            tasks.add(task.read(field, amslMeters));
        }
        return tasks;
    }

    /**
     * Throws {@link InvalidInput} where a member cannot be used.
     *
     * @param at what stands before its members' names, such as {@code waypoints[0].tasks[1].}
     * @param amslMeters what an altitude as written means above the sea
     */
    WaypointTask read(String at, ToDoubleFunction<@Nullable Double> amslMeters);

    /** One picture. */
    @Schema(name = "PlanPhotoTask", description = "One picture.")
    record Photo() implements PlanTaskRequest {
        @Override
        public WaypointTask read(String at, ToDoubleFunction<@Nullable Double> amslMeters) {
            return new WaypointTask.Photo();
        }
    }

    /** An output of the vehicle. */
    @Schema(name = "PlanServoTask", description = "An output of the vehicle is set.")
    record Servo(
            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Which output, 1 to 32")
            @Min(1)
            @Max(MissionItem.SetServo.MOST_OUTPUTS)
            @Nullable
            Integer output,

            @Schema(
                    requiredMode = Schema.RequiredMode.REQUIRED,
                    description = "Length of its pulses in microseconds, 500 to 2500")
            @Min(MissionItem.SetServo.SHORTEST_MICROS)
            @Max(MissionItem.SetServo.LONGEST_MICROS)
            @Nullable
            Integer pulse)
            implements PlanTaskRequest {
        @Override
        public WaypointTask read(String at, ToDoubleFunction<@Nullable Double> amslMeters) {
            MissionItem.SetServo servo = MissionReader.servo(at, output, pulse);
            return new WaypointTask.Servo(servo.output(), servo.pulseMicros());
        }
    }

    /** A place that camera and nose point to. */
    @Schema(name = "PlanLookAtTask", description = "Camera and nose point to a place.")
    record LookAt(
            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Degrees")
            @Min(-FieldRanges.LATITUDE)
            @Max(FieldRanges.LATITUDE)
            @Nullable
            Double latitude,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Degrees")
            @Min(-FieldRanges.LONGITUDE)
            @Max(FieldRanges.LONGITUDE)
            @Nullable
            Double longitude,

            @Schema(
                    requiredMode = Schema.RequiredMode.REQUIRED,
                    description = "Metres; as of what is said by the waypoint's altitudeReference")
            @Min(Altitude.LOWEST_PLANNED_METERS)
            @Max(Altitude.HIGHEST_PLANNED_METERS)
            @Nullable
            Double altitude)
            implements PlanTaskRequest {
        @Override
        public WaypointTask read(String at, ToDoubleFunction<@Nullable Double> amslMeters) {
            Geodetic point = new Geodetic(
                    FieldRanges.latitude(at + "latitude", latitude),
                    FieldRanges.longitude(at + "longitude", longitude));
            return new WaypointTask.Look(
                    point, amslMeters.applyAsDouble(FieldRanges.altitude(at + "altitude", altitude)));
        }
    }

    /** A time in which what the sensors tell is kept. */
    @Schema(name = "PlanReadSensorsTask", description = "It stays, and what its sensors tell meanwhile is kept.")
    record ReadSensors(
            @Schema(description = "For how long in seconds, 1 to 3600; left out: 5")
            @Min(ReadSensors.LEAST_SECONDS)
            @Max(FieldRanges.MOST_SECONDS)
            @Nullable
            Double seconds)
            implements PlanTaskRequest {
        static final int LEAST_SECONDS = 1;
        private static final double USUAL_SECONDS = 5;

        @Override
        public WaypointTask read(String at, ToDoubleFunction<@Nullable Double> amslMeters) {
            double asked = seconds == null ? USUAL_SECONDS : seconds;
            return new WaypointTask.Sensors(
                    FieldRanges.checked(at + "seconds", asked, LEAST_SECONDS, FieldRanges.MOST_SECONDS, "seconds"));
        }
    }
}
