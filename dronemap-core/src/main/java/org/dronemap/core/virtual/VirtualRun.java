package org.dronemap.core.virtual;

import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.Map;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.mission.Mission;
import org.jspecify.annotations.Nullable;

/**
 * The flight of a virtual drone's mission, from the user's request to its end; immutable. Each waypoint below {@code
 * flown} is behind it; all others are the one assignment's, or nobody's.
 *
 * @param ticket who asked first has the lower one, and goes first
 * @param mission as it was planned when it was asked for; a {@link VirtualTour}
 * @param onCloudLoss what a drone does by itself when it no longer hears the cloud
 * @param assignment not null exactly as long as it is bound
 * @param avoided drones that could not go on, and until when none of them is asked again
 * @param failures drones that could not go on, in all
 * @param note names no drone
 * @param detail what the drone or the gate said, for those who may know the drone; null: nothing
 */
public record VirtualRun(
        long ticket,
        Mission mission,
        MissionCloudLossPolicy onCloudLoss,
        int flown,
        VirtualRunStage stage,
        @Nullable VirtualRunAssignment assignment,
        Map<DroneId, Instant> avoided,
        int failures,
        String note,
        @Nullable String detail,
        Instant changedAt) {
    public VirtualRun {
        avoided = Map.copyOf(avoided);
        if (stage.isBound() != (assignment != null)) {
            throw new IllegalArgumentException(stage + " with assignment " + assignment);
        }
    }

    /** Has just been asked for. */
    public static VirtualRun asked(long ticket, Mission mission, MissionCloudLossPolicy onCloudLoss, Instant now) {
        return new VirtualRun(
                ticket,
                mission,
                onCloudLoss,
                0,
                VirtualRunStage.QUEUED,
                null,
                Map.of(),
                0,
                "It waits for a drone.",
                null,
                now);
    }

    public VirtualTour tour() {
        return VirtualTour.of(mission);
    }

    /** Waypoints in all. */
    public int total() {
        return tour().waypoints().size();
    }

    /** Bound to that drone, which is given nothing yet. */
    public VirtualRun bound(DroneChoice choice, @Nullable Double takeOffMeters, Instant now) {
        VirtualRunAssignment next = new VirtualRunAssignment(choice, flown, takeOffMeters, null, 0, now);
        return with(VirtualRunStage.UPLOADING, next, "A drone is bound and gets the mission.", null, now);
    }

    /** The same drone in another stage. */
    VirtualRun to(VirtualRunStage next, String words, Instant now) {
        return to(next, 0, words, now);
    }

    /** The same drone in another stage, where that many tries count as failed already. */
    VirtualRun to(VirtualRunStage next, int failed, String words, Instant now) {
        VirtualRunAssignment served = assignment == null ? null : assignment.fresh(failed, now);
        return with(next, served, words, null, now);
    }

    /** It shall not go on for now, whoever has its drone. */
    public VirtualRun setAside(String why, Instant at) {
        return unbound(VirtualRunStage.SUSPENDED, "Resume when it shall go on, or stop.", why, at);
    }

    /** Without a drone. */
    VirtualRun unbound(VirtualRunStage next, String words, @Nullable String why, Instant now) {
        return with(next, null, words, why, now);
    }

    /** In the queue again, where it stood before; that drone is not asked again until then. */
    VirtualRun requeued(DroneId drone, Instant until, String words, Instant now) {
        Map<DroneId, Instant> next = new LinkedHashMap<>(avoided);
        next.put(drone, until);
        return new VirtualRun(
                ticket,
                mission,
                onCloudLoss,
                flown,
                VirtualRunStage.QUEUED,
                null,
                next,
                failures + 1,
                words,
                detail,
                now);
    }

    /** By the user's word, who has looked at why it stopped. */
    VirtualRun resumed(Instant now) {
        return new VirtualRun(
                ticket,
                mission,
                onCloudLoss,
                flown,
                VirtualRunStage.QUEUED,
                null,
                Map.of(),
                0,
                "It waits for a drone.",
                null,
                now);
    }

    /** The command is about to be given. */
    public VirtualRun given(CommandId command, Instant now) {
        return with(stage, assignment == null ? null : assignment.given(command, now), note, detail, changedAt);
    }

    VirtualRun failedTry(String why, Instant now) {
        VirtualRunAssignment again = assignment == null ? null : assignment.fresh(assignment.tries() + 1, now);
        return with(stage, again, note, why, changedAt);
    }

    /** The same is tried again later, which is no failed try; when the stage began stays as it was. */
    VirtualRun waiting(String words, String why, Instant now) {
        VirtualRunAssignment again = assignment == null ? null : assignment.fresh(assignment.tries(), now);
        return with(stage, again, words, why, changedAt);
    }

    VirtualRun flown(int waypoints) {
        return waypoints <= flown
                ? this
                : new VirtualRun(
                        ticket,
                        mission,
                        onCloudLoss,
                        waypoints,
                        stage,
                        assignment,
                        avoided,
                        failures,
                        note,
                        detail,
                        changedAt);
    }

    /** Says something else of the same. */
    VirtualRun withNote(String words, Instant now) {
        return words.equals(note) ? this : with(stage, assignment, words, detail, now);
    }

    private VirtualRun with(
            VirtualRunStage next,
            @Nullable VirtualRunAssignment served,
            String words,
            @Nullable String why,
            Instant now) {
        return new VirtualRun(ticket, mission, onCloudLoss, flown, next, served, avoided, failures, words, why, now);
    }
}
