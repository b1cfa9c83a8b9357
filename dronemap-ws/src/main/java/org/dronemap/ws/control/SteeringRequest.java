package org.dronemap.ws.control;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
import java.util.Objects;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.command.Setpoint.Facing;
import org.dronemap.core.command.Setpoint.Frame;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;

/**
 * A client's request to move a drone now, by velocities or by stick positions. Nothing is checked yet.
 *
 * @param epoch of the control that the client believes to have; null: it does not say
 */
public record SteeringRequest(
        @Nullable Velocity velocity,
        @Nullable Sticks sticks,
        @Nullable Long epoch) {
    private static final int FASTEST = (int) Setpoint.Velocity.FASTEST;
    private static final int WHOLE_TURN = (int) Setpoint.WHOLE_TURN;
    private static final String FRAMES = "vehicle (the default) or earth";

    /**
     * Speeds in m/s; what is left out is 0.
     *
     * @param frame from the vehicle's nose, or from true north
     * @param turn degrees a second, clockwise seen from above
     * @param heading degrees clockwise from true north, where it shall look; not beside {@code turn}
     */
    @Schema(name = "SteeringVelocity", description = "Speeds in m/s, each at most 100; what is left out is 0.")
    public record Velocity(
            @Schema(
                    description = "From the vehicle's nose, or from true north; left out: vehicle",
                    allowableValues = {"vehicle", "earth"})
            @Nullable
            String frame,

            @Min(-FASTEST) @Max(FASTEST) @Nullable Double forward,
            @Min(-FASTEST) @Max(FASTEST) @Nullable Double right,
            @Min(-FASTEST) @Max(FASTEST) @Nullable Double down,

            @Schema(description = "degrees a second, clockwise seen from above")
            @Min(-WHOLE_TURN)
            @Max(WHOLE_TURN)
            @Nullable
            Double turn,

            @Schema(description = "degrees clockwise from true north, where it shall look; not beside turn")
            @Min(-WHOLE_TURN)
            @Max(WHOLE_TURN)
            @Nullable
            Double heading) {}

    /** Each −1 to 1, with 0 in the middle; what is left out is there. */
    @Schema(name = "SteeringSticks", description = "Each -1 to 1, with 0 in the middle; what is left out is there.")
    public record Sticks(
            @Min(-1) @Max(1) @Nullable Double forward,
            @Min(-1) @Max(1) @Nullable Double right,
            @Min(-1) @Max(1) @Nullable Double up,
            @Min(-1) @Max(1) @Nullable Double turn) {}

    /** Throws {@link InvalidInput} for what is none. */
    Setpoint setpoint() {
        Velocity speeds = velocity;
        Sticks moved = sticks;
        if (speeds == null && moved == null) {
            throw InvalidInput.missing("velocity", "speeds such as {\"forward\":1}, or \"sticks\" in their place");
        }
        if (speeds != null && moved != null) {
            throw InvalidInput.outside(
                    ValueProblem.VALUES_EXCLUSIVE, "sticks", "alone, or velocity alone", "beside the other");
        }
        try {
            if (moved != null) {
                return new Setpoint.Sticks(
                        orZero(moved.forward()), orZero(moved.right()), orZero(moved.up()), orZero(moved.turn()));
            }
            return speeds(Objects.requireNonNull(speeds));
        } catch (IllegalArgumentException outside) {
            throw new InvalidInput(
                    ValueProblem.VALUE_OUT_OF_RANGE,
                    "velocity",
                    "within bounds",
                    "This cannot be steered by: " + outside.getMessage() + ".");
        }
    }

    private static Setpoint speeds(Velocity said) {
        return new Setpoint.Velocity(
                frame(said.frame()), orZero(said.forward()), orZero(said.right()), orZero(said.down()), facing(said));
    }

    private static Frame frame(@Nullable String name) {
        if (name == null || name.equals("vehicle")) {
            return Frame.VEHICLE;
        }
        if (name.equals("earth")) {
            return Frame.EARTH;
        }
        throw InvalidInput.outside(ValueProblem.VALUE_NOT_ALLOWED, "velocity.frame", FRAMES, "\"" + name + "\"");
    }

    private static Facing facing(Velocity said) {
        Double heading = said.heading();
        Double turn = said.turn();
        if (heading != null && turn != null) {
            throw InvalidInput.outside(
                    ValueProblem.VALUES_EXCLUSIVE, "velocity.heading", "alone, or turn alone", "beside the other");
        }
        if (heading != null) {
            return new Facing.Heading(heading);
        }
        return turn == null ? Facing.ANY : new Facing.Turning(turn);
    }

    private static double orZero(@Nullable Double value) {
        return value == null ? 0 : value;
    }
}
