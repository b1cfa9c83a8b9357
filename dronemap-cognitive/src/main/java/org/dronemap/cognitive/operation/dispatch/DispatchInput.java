package org.dronemap.cognitive.operation.dispatch;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.operation.ChosenDrone;
import org.dronemap.core.separation.GiveWay;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/** An input of the dispatch state machine. */
public sealed interface DispatchInput {
    Instant at();

    /** An observation of all drones of the dispatch; who is not among them was removed. */
    @Stored(as = "Observed", names = "at looks")
    record Observed(Instant at, List<Look> looks) implements DispatchInput {
        public Observed {
            looks = List.copyOf(looks);
        }

        Optional<Look> of(DroneId drone) {
            return looks.stream().filter(look -> look.drone().equals(drone)).findFirst();
        }
    }

    /**
     * Observation of one drone: its control, flight mode and place.
     *
     * @param giveWay to whom it gives way; null: to nobody
     * @param fallingLink why its link is expected to be lost soon, as a sentence; null: it is not
     */
    @Stored(names = "drone control flight place giveWay fallingLink", later = "giveWay fallingLink")
    record Look(
            DroneId drone,
            Control control,
            Flight flight,
            Place place,
            @Nullable GiveWay giveWay,
            @Nullable String fallingLink) {
        /** What it does for another drone now, as a sentence; null: nothing. */
        @Nullable
        String aside(String name) {
            return giveWay == null || !standsAside() ? null : giveWay.sentence(name);
        }

        boolean standsAside() {
            return giveWay != null && giveWay.standsAside();
        }
    }

    /**
     * Control of the drone as the dispatch sees it.
     *
     * @param whyNotHeld null: the dispatch has it
     * @param whyNotAllowed why drones are not commanded for whoever asked any more, as a sentence; null: they are
     * @param owned whoever asked has it
     * @param free nobody has it
     */
    @Stored(names = "whyNotHeld whyNotAllowed owned free")
    record Control(@Nullable String whyNotHeld, @Nullable String whyNotAllowed, boolean owned, boolean free) {}

    /**
     * Motors and flight mode of the drone.
     *
     * @param guided it does what it is told
     * @param homing it comes home or down by itself
     * @param steered it is in a mode for a pilot's sticks
     * @param mode as people call it; null: not known
     * @param orders the mode in which it can be led; null: it has none
     */
    @Stored(names = "armed airborne guided homing steered mode orders")
    record Flight(
            boolean armed,
            boolean airborne,
            boolean guided,
            boolean homing,
            boolean steered,
            @Nullable String mode,
            @Nullable String orders) {}

    /**
     * Position, battery and link of the drone; what is null is not known.
     *
     * @param silentSeconds for how long it is not heard, zero while its link is live
     * @param homeMeters to its home
     * @param awayMeters over ground to the place where it is wanted
     * @param heightMeters above its home
     */
    @Stored(names = "silentSeconds batteryPercent homeMeters awayMeters heightMeters")
    record Place(
            int silentSeconds,
            @Nullable Integer batteryPercent,
            @Nullable Double homeMeters,
            @Nullable Double awayMeters,
            @Nullable Double heightMeters) {}

    @Stored(as = "CommandEnded", names = "at drone command outcome")
    record CommandEnded(Instant at, DroneId drone, CommandId command, Outcome outcome) implements DispatchInput {}

    /** The process was started again. */
    @Stored(as = "Resumed", names = "at")
    record Restarted(Instant at) implements DispatchInput {}

    /** That drone comes in the place of one that could not. */
    @Stored(as = "SendDrone", names = "at chosen")
    record SendDrone(Instant at, ChosenDrone chosen) implements DispatchInput {}

    /** No other drone can come; {@code why} as one or more sentences. */
    @Stored(as = "NoDroneAvailable", names = "at why")
    record NoDroneAvailable(Instant at, String why) implements DispatchInput {}

    /** A user calls it off: whatever flies for it comes home. */
    @Stored(as = "Cancel", names = "at by")
    record Cancel(Instant at, String by) implements DispatchInput {}
}
