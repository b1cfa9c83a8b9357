package org.dronemap.core.virtual;

import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.mission.Mission;
import org.jspecify.annotations.Nullable;

/**
 * The flight of a virtual drone's mission, or of one share of it, from the user's request to its end; immutable. Each
 * waypoint below {@code flown} is behind it; all others are the one assignment's, or nobody's.
 *
 * @param assignment not null exactly as long as it is bound
 * @param avoided drones that could not go on, and until when none of them is asked again
 * @param failures drones that could not go on, in all
 * @param note names no drone
 * @param detail what the drone or the gate said, for those who may know the drone; null: nothing
 */
public record VirtualRun(
        VirtualRunOrder order,
        int flown,
        VirtualRunStage stage,
        @Nullable VirtualRunAssignment assignment,
        Map<DroneId, Instant> avoided,
        int failures,
        String note,
        @Nullable String detail,
        Instant changedAt) {
    private static final String WAITS = "It waits for a drone.";

    public VirtualRun {
        avoided = Map.copyOf(avoided);
        if (stage.isBound() != (assignment != null)) {
            throw new IllegalArgumentException(stage + " with assignment " + assignment);
        }
    }

    /** Has just been asked for. */
    public static VirtualRun asked(VirtualRunOrder order, Instant now) {
        return new VirtualRun(order, 0, VirtualRunStage.QUEUED, null, Map.of(), 0, WAITS, null, now);
    }

    /** Runs of the shares, each for one drone, in the place of this one, of which nothing is flown. */
    public List<VirtualRun> divided(List<Mission> shares, Instant now) {
        return shares.stream()
                .map(share -> new VirtualRunOrder(ticket(), share, onCloudLoss(), 1))
                .map(share ->
                        new VirtualRun(share, 0, VirtualRunStage.QUEUED, null, avoided, failures, WAITS, null, now))
                .toList();
    }

    public long ticket() {
        return order.ticket();
    }

    public Mission mission() {
        return order.mission();
    }

    public MissionCloudLossPolicy onCloudLoss() {
        return order.onCloudLoss();
    }

    /** Several drones may share it, since none has flown any of it. */
    public boolean isDivisible() {
        return stage == VirtualRunStage.QUEUED && flown == 0 && order.upTo() > 1 && total() > 1;
    }

    public boolean isWaiting() {
        return stage == VirtualRunStage.QUEUED;
    }

    /** The drone that serves it; null: none. */
    public @Nullable DroneId boundTo() {
        return assignment == null ? null : assignment.drone();
    }

    public VirtualTour tour() {
        return VirtualTour.of(mission());
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
        return new VirtualRun(order, flown, VirtualRunStage.QUEUED, null, next, failures + 1, words, detail, now);
    }

    /** By the user's word, who has looked at why it stopped. */
    VirtualRun resumed(Instant now) {
        return new VirtualRun(order, flown, VirtualRunStage.QUEUED, null, Map.of(), 0, WAITS, null, now);
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
                : new VirtualRun(order, waypoints, stage, assignment, avoided, failures, note, detail, changedAt);
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
        return new VirtualRun(order, flown, next, served, avoided, failures, words, why, now);
    }
}
