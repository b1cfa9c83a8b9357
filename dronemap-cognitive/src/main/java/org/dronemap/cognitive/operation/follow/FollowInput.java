package org.dronemap.cognitive.operation.follow;

import java.time.Instant;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/** What befalls a follow. */
public sealed interface FollowInput {
    Instant at();

    /**
     * What was seen.
     *
     * @param drone null: it was removed
     * @param sighted when the newest position of the phone came; null: none did
     * @param unsteered why the drone could not be steered, as a sentence; null: it was, or nobody wanted to
     */
    record Looked(
            Instant at,
            @Nullable Look drone,
            @Nullable Instant sighted,
            @Nullable String unsteered) implements FollowInput {}

    /**
     * The drone.
     *
     * @param takenBy why the follow has no control of it, as a sentence; null: it has
     * @param silentSeconds for how long nothing was heard of it
     * @param guided it goes by what it is led by, or waits for that
     * @param homing it comes home or down by itself
     * @param mode as people call it; null: not known
     * @param homeMeters how far it is from its home; null: not known
     */
    record Look(
            @Nullable String takenBy,
            int silentSeconds,
            boolean armed,
            boolean airborne,
            boolean guided,
            boolean homing,
            @Nullable String mode,
            @Nullable Integer batteryPercent,
            @Nullable Double homeMeters) {}

    record CommandEnded(Instant at, DroneId drone, CommandId command, Outcome outcome) implements FollowInput {}

    /** The process was started again. */
    record Resumed(Instant at) implements FollowInput {}

    /** What somebody wants of it. */
    sealed interface Wish extends FollowInput {
        /** The user's name. */
        String by();
    }

    /** The drone takes off and comes. */
    record Start(Instant at, String by) implements Wish {}

    /** It is called off before it follows. */
    record Cancel(Instant at, String by) implements Wish {}

    /** The drone stays where it is. */
    record Pause(Instant at, String by) implements Wish {}

    /** The drone follows again; the only way back for one that somebody took. */
    record GoOn(Instant at, String by) implements Wish {}

    /** The drone flies home. */
    record Stop(Instant at, String by) implements Wish {}

    /** The drone stays elsewhere beside the phone. */
    record Change(Instant at, String by, FollowOrder.Place place) implements Wish {}
}
