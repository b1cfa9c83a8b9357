package org.dronemap.cognitive.operation.follow;

import java.time.Instant;
import java.util.List;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.operation.ChosenDrone;
import org.dronemap.core.operation.ReporterState;
import org.dronemap.core.separation.GiveWay;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/** An input of a follow: an observation, a command's outcome, a restart or a user's request. */
public sealed interface FollowInput {
    Instant at();

    /**
     * An observation of all drones of the follow and of its phone.
     *
     * @param drone null: it was removed
     * @param lastReport when the newest position of the phone came; null: none did
     * @param reach how the phone is reached; null: not known
     * @param steeringRefusal why the drone could not be steered, as a sentence; null: it was, or nobody wanted to
     * @param others the follow's other drones
     */
    @Stored(as = "Looked", names = "at drone sighted reach unsteered others")
    record Observed(
            Instant at,
            @Nullable Observation drone,
            @Nullable Instant lastReport,
            @Nullable ReporterState reach,
            @Nullable String steeringRefusal,
            List<OtherDrone> others)
            implements FollowInput {
        public Observed {
            others = List.copyOf(others);
        }

        public Observed(
                Instant at,
                @Nullable Observation drone,
                @Nullable Instant sighted,
                @Nullable ReporterState reach,
                @Nullable String unsteered) {
            this(at, drone, sighted, reach, unsteered, List.of());
        }

        /** The same for that one of the others. */
        Observed of(DroneId drone) {
            Observation look = others.stream()
                    .filter(other -> other.drone().equals(drone))
                    .findFirst()
                    .map(OtherDrone::look)
                    .orElse(null);
            return new Observed(at, look, lastReport, reach, null);
        }
    }

    /**
     * A drone that comes to replace the one that leads, or that was replaced.
     *
     * @param look null: it was removed
     * @param apartMeters on the ground from the one that leads; null: not known, or it still rises
     */
    @Stored(names = "drone look apartMeters")
    record OtherDrone(
            DroneId drone,
            @Nullable Observation look,
            @Nullable Double apartMeters) {}

    /**
     * The drone.
     *
     * @param whyNotHeld why the follow has no control of it, as a sentence; null: it has
     * @param silentSeconds for how long nothing was heard of it
     * @param guided it goes by what it is led by, or waits for that
     * @param homing it comes home or down by itself
     * @param mode as people call it; null: not known
     * @param homeMeters how far it is from its home; null: not known
     * @param restriction null: nothing of that
     * @param modes null: written before anybody asked for them
     * @param fallingLink why its link is expected to be lost soon, as a sentence; null: it is not
     * @param giveWay to whom it gives way where it is not led; null: to nobody
     * @param unchecked nobody can know yet whether another drone is in the way of its take-off; null: that is known
     */
    @Stored(
            names = "takenBy silentSeconds armed airborne guided homing mode batteryPercent homeMeters grip modes "
                    + "fallingLink giveWay unchecked",
            later = "modes fallingLink giveWay unchecked")
    record Observation(
            @Nullable String whyNotHeld,
            int silentSeconds,
            boolean armed,
            boolean airborne,
            boolean guided,
            boolean homing,
            @Nullable String mode,
            @Nullable Integer batteryPercent,
            @Nullable Double homeMeters,
            @Nullable ControlRestriction restriction,
            @Nullable ModeMeaning modes,
            @Nullable String fallingLink,
            @Nullable GiveWay giveWay,
            @Nullable Boolean unchecked) {
        /** Its link is not expected to be lost, and nobody is in its way. */
        public Observation(
                @Nullable String whyNotHeld,
                int silentSeconds,
                boolean armed,
                boolean airborne,
                boolean guided,
                boolean homing,
                @Nullable String mode,
                @Nullable Integer batteryPercent,
                @Nullable Double homeMeters,
                @Nullable ControlRestriction restriction,
                @Nullable ModeMeaning modes) {
            this(
                    whyNotHeld,
                    silentSeconds,
                    armed,
                    airborne,
                    guided,
                    homing,
                    mode,
                    batteryPercent,
                    homeMeters,
                    restriction,
                    modes,
                    null,
                    null,
                    null);
        }

        /** Before it rises, another drone has to pass. */
        boolean waitsOnTheGround() {
            return giveWay != null && !armed;
        }

        boolean mayRise() {
            return !Boolean.TRUE.equals(unchecked);
        }

        boolean standsAside() {
            return giveWay != null && giveWay.standsAside();
        }

        /** The same, with what its modes are for. */
        public Observation with(@Nullable ModeMeaning told) {
            return new Observation(
                    whyNotHeld,
                    silentSeconds,
                    armed,
                    airborne,
                    guided,
                    homing,
                    mode,
                    batteryPercent,
                    homeMeters,
                    restriction,
                    told,
                    fallingLink,
                    giveWay,
                    unchecked);
        }
    }

    /**
     * Control of the drone while the follow does not have it alone.
     *
     * @param commandRefusal why drones are not commanded for whoever asked any more, as a sentence; null: they are
     * @param withoutHolder nobody has control of it, and it waits for somebody with its motors running
     * @param steered it is in a mode for a pilot's sticks
     */
    @Stored(names = "barred adrift steered")
    record ControlRestriction(@Nullable String commandRefusal, boolean withoutHolder, boolean steered) {}

    /**
     * The meaning of the drone's flight mode for the follow.
     *
     * @param orders the one in which it can be led; null: it has none
     * @param home it is in one in which it comes home
     */
    @Stored(names = "orders home")
    record ModeMeaning(@Nullable String orders, boolean home) {}

    @Stored(as = "CommandEnded", names = "at drone command outcome")
    record CommandEnded(Instant at, DroneId drone, CommandId command, Outcome outcome) implements FollowInput {}

    /** The process was started again. */
    @Stored(as = "Resumed", names = "at")
    record Restarted(Instant at) implements FollowInput {}

    /** That drone is sent to replace the one that leads. */
    @Stored(as = "Relieve", names = "at chosen")
    record SendRelief(Instant at, ChosenDrone chosen) implements FollowInput {}

    /** No drone can be sent for that; {@code why} as one or more sentences. */
    @Stored(as = "Unrelieved", names = "at why")
    record NoReliefAvailable(Instant at, String why) implements FollowInput {}

    /** A request of a user. */
    sealed interface UserRequest extends FollowInput {
        /** The user's name. */
        String by();
    }

    /** The drone takes off and comes. */
    @Stored(as = "Start", names = "at by")
    record Start(Instant at, String by) implements UserRequest {}

    /** It is called off before it follows. */
    @Stored(as = "Cancel", names = "at by")
    record Cancel(Instant at, String by) implements UserRequest {}

    /** The drone stays where it is. */
    @Stored(as = "Pause", names = "at by")
    record Pause(Instant at, String by) implements UserRequest {}

    /** The drone follows again; the only way back for one that somebody took. */
    @Stored(as = "GoOn", names = "at by")
    record Resume(Instant at, String by) implements UserRequest {}

    /** The drone flies home. */
    @Stored(as = "Stop", names = "at by")
    record Stop(Instant at, String by) implements UserRequest {}

    /** The drone stays elsewhere beside the phone. */
    @Stored(as = "Change", names = "at by place")
    record ChangePlace(Instant at, String by, FollowOrder.RelativePlace place) implements UserRequest {}
}
