package org.dronemap.cognitive.operation.recovery;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.separation.GiveWay;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/** An input of the recovery state machine. */
public sealed interface RecoveryInput {
    Instant at();

    /** An observation of all drones of the recovery; who is not among them was removed. */
    @Stored(as = "Observed", names = "at looks")
    record Observed(Instant at, List<Look> looks) implements RecoveryInput {
        public Observed {
            looks = List.copyOf(looks);
        }

        Optional<Look> of(DroneId drone) {
            return looks.stream().filter(look -> look.drone().equals(drone)).findFirst();
        }
    }

    /**
     * Observation of one drone.
     *
     * @param whyNotHeld why the recovery does not have control of it, as a sentence; null: it has
     * @param giveWay to whom it gives way; null: to nobody
     */
    @Stored(names = "drone whyNotHeld silentSeconds flight place giveWay")
    record Look(
            DroneId drone,
            @Nullable String whyNotHeld,
            int silentSeconds,
            Flight flight,
            Place place,
            @Nullable GiveWay giveWay) {
        boolean isSilent() {
            return silentSeconds > 0;
        }
    }

    /**
     * Motors and flight mode of the drone.
     *
     * @param waits it stands, or goes where it is sent
     * @param homing it comes home or down by itself
     * @param steered it is in a mode for a pilot's sticks
     * @param stands it does not move
     * @param mode as people call it; null: not known
     */
    @Stored(names = "armed airborne waits homing steered stands mode")
    record Flight(
            boolean armed,
            boolean airborne,
            boolean waits,
            boolean homing,
            boolean steered,
            boolean stands,
            @Nullable String mode) {}

    /**
     * Position and battery of the drone; what is null is not known.
     *
     * @param heightMeters above its home
     * @param homeAmslMeters of its home, above the sea
     * @param returnMeters above home, at which the cloud has it return
     * @param returnBeforeMeters what was set before that
     */
    @Stored(names = "point heightMeters home homeAmslMeters batteryPercent returnMeters returnBeforeMeters")
    record Place(
            @Nullable Geodetic point,
            @Nullable Double heightMeters,
            @Nullable Geodetic home,
            @Nullable Double homeAmslMeters,
            @Nullable Integer batteryPercent,
            @Nullable Double returnMeters,
            @Nullable Double returnBeforeMeters) {}

    @Stored(as = "CommandEnded", names = "at drone command outcome")
    record CommandEnded(Instant at, DroneId drone, CommandId command, Outcome outcome) implements RecoveryInput {}

    /** The process was started again. */
    @Stored(as = "Resumed", names = "at")
    record Restarted(Instant at) implements RecoveryInput {}

    /** A user calls it off: whoever asked for it gets its drones back. */
    @Stored(as = "Cancel", names = "at by")
    record Cancel(Instant at, String by) implements RecoveryInput {}
}
