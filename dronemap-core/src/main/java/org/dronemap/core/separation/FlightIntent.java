package org.dronemap.core.separation;

import java.time.Instant;
import java.util.List;
import org.dronemap.core.command.Command;
import org.dronemap.core.mission.MissionItem;
import org.jspecify.annotations.Nullable;

/**
 * Intent of an operation for one of its drones: what it does next, as far as the drone itself does not show it.
 *
 * @param items what it has on board to be flown, or is about to start, from the item that it heads for on
 * @param pace how fast it flies them; null: not known
 * @param commanded a command for that is under way to it
 * @param since since when
 * @param bounds what keeps it from stepping aside beyond the zones of the cloud
 * @param goesOnAlone it flies its mission on to its end when it hears no server any more
 */
public record FlightIntent(
        Step step,
        List<MissionItem> items,
        @Nullable FlightPace pace,
        boolean commanded,
        Instant since,
        Bounds bounds,
        boolean goesOnAlone) {
    /** Bounds that an operation alone has. */
    public interface Bounds {
        Bounds NONE = (drone, there) -> true;

        /** Whether it may go there from where it is. */
        boolean allow(TrackedDrone drone, Command.GoTo there);
    }

    /** The step that is next. */
    public enum Step {
        /** Takes off as soon as that is clear. */
        RISE,
        /** Flies its mission. */
        FLY,
        /** Goes to the place that it was told to go to. */
        GO,
        /** Stands in the air until something else is decided. */
        STAND,
        /** Stands, and flies its mission on as soon as that is clear. */
        GO_ON,
        /** Comes home. */
        COME_HOME,
        /** It has fallen: it lies on the ground, whatever it says itself. */
        LIE
    }

    public FlightIntent(
            Step step, List<MissionItem> items, @Nullable FlightPace pace, boolean commanded, Instant since) {
        this(step, items, pace, commanded, since, Bounds.NONE, false);
    }

    public FlightIntent goingOnAlone(boolean alone) {
        return new FlightIntent(step, items, pace, commanded, since, bounds, alone);
    }

    /** Also of a drone that no operation has any more, or yet: that it lies, or rises. */
    public boolean countsForAnybody() {
        return step == Step.LIE || step == Step.RISE;
    }

    public FlightIntent {
        items = List.copyOf(items);
    }
}
