package org.dronemap.cognitive.operation.run.model;

import java.time.Duration;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.PayloadState;
import org.dronemap.core.drone.ReturnHeight;
import org.dronemap.core.separation.GiveWay;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * Observation of one drone of a mission run at one moment; null where not known.
 *
 * @param holder why the run has no control of it, as a sentence; null: it has
 * @param silence for how long nothing was heard
 * @param ready what it can do is known
 * @param still for how long it has not moved
 * @param ordersMode the mode to put it into before it is armed; null: it is in such a one, or has none
 * @param steering what it goes by
 * @param climb m/s, positive upwards
 * @param tiltDegrees how far it leans
 * @param canGoTo whether it goes to a place that it is told
 * @param payload what it says of camera, servos and sensors; nothing where no task is to be seen to
 * @param canReturn whether it knows a way home of its own, else it is told to land
 * @param returnHeight null: the cloud has not set it
 * @param transfer of its mission, which is under way and may be somebody else's; null: none is
 * @param giveWay to whom it gives way; null: to nobody
 * @param fallingLink why its link is expected to be lost soon, as a sentence; null: it is not
 */
@Stored(
        names = "drone takenBy link silence still ready mode ordersMode steering armed airborne place "
                + "aboveHomeMeters climb speed tiltDegrees batteryPercent canGoTo canReturn returnHeight "
                + "progress payload transfer giveWay fallingLink",
        later = "giveWay fallingLink")
public record DroneObservation(
        DroneId drone,
        @Nullable String holder,
        LinkState link,
        Duration silence,
        Duration still,
        boolean ready,
        @Nullable String mode,
        @Nullable String ordersMode,
        @Nullable Steering steering,
        @Nullable Boolean armed,
        boolean airborne,
        @Nullable Place place,
        @Nullable Double aboveHomeMeters,
        @Nullable Double climb,
        @Nullable Double speed,
        @Nullable Double tiltDegrees,
        @Nullable Integer batteryPercent,
        boolean canGoTo,
        boolean canReturn,
        @Nullable ReturnHeight returnHeight,
        Progress progress,
        PayloadState payload,
        @Nullable String transfer,
        @Nullable GiveWay giveWay,
        @Nullable String fallingLink) {
    /** m/s over ground: whoever is slower stands. */
    private static final double STANDS_SPEED = 2;

    /**
     * The progress of a drone in its mission.
     *
     * @param carries whether it has on board what it flies; null: not known
     * @param carriesNext whether it has on board what it is to get; null: not known, or there is nothing
     * @param known it has said which mission it has and where in it it is, so that what follows can be relied on
     * @param passed how many items of what it has on board are behind it
     * @param complete flown to the end
     * @param nextFault of what it is to get, the first item that its vehicle does not fly; null: none is known
     */
    @Stored(names = "carries carriesNext told passed complete nextFault", later = "nextFault")
    public record Progress(
            @Nullable Boolean carries,
            @Nullable Boolean carriesNext,
            boolean known,
            int passed,
            boolean complete,
            @Nullable ItemFault nextFault) {}

    /**
     * An item of a mission that the vehicle does not fly as it is written.
     *
     * @param item its number, from 0
     */
    @Stored(names = "item sentence")
    public record ItemFault(int item, String sentence) {}

    public boolean isLive() {
        return link == LinkState.LIVE;
    }

    /** All is known that its part in the run is judged by. */
    public boolean isFullyReported() {
        return isLive() && ready && mode != null && armed != null && place != null && progress.known();
    }

    /** It has flown what it was given. */
    public boolean isAtTheEnd() {
        return progress.complete() && !Boolean.FALSE.equals(progress.carries());
    }

    public boolean isLost() {
        return link == LinkState.LOST || link == LinkState.ENDED;
    }

    public boolean isArmed() {
        return Boolean.TRUE.equals(armed);
    }

    /** It was told to stand, and does not yet. */
    public boolean isStillMoving() {
        return waits() && speed != null && speed > STANDS_SPEED;
    }

    public boolean isDisarmed() {
        return Boolean.FALSE.equals(armed);
    }

    public boolean isOnMission() {
        return steering == Steering.MISSION;
    }

    public boolean waits() {
        return steering != null && steering.acceptsCommands();
    }

    public boolean comesDown() {
        return steering != null && steering.isSafe();
    }

    /** Somebody's sticks, or a way of flying that nobody here asks for. */
    public boolean isSteered() {
        return mode != null && (steering == null || steering == Steering.STICKS);
    }
}
