package org.dronemap.core.virtual;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.IntStream;

/**
 * The progress of a virtual drone's mission as a whole, over all its shares.
 *
 * @param stage of a share that is under way the furthest one, else that of what still waits or went wrong
 * @param sentence names no drone
 * @param flown waypoints of all shares
 * @param total waypoints of all shares
 * @param drones that serve it now
 */
public record VirtualProgress(
        VirtualRunStage stage, String sentence, int flown, int total, int drones, Instant changedAt) {
    /** Which of several stages is told of the whole, the first one first. */
    private static final List<VirtualRunStage> TOLD = List.of(
            VirtualRunStage.STOPPING,
            VirtualRunStage.FLYING,
            VirtualRunStage.STARTING,
            VirtualRunStage.ARMING,
            VirtualRunStage.UPLOADING,
            VirtualRunStage.GIVING_UP,
            VirtualRunStage.RETURNING,
            VirtualRunStage.QUEUED,
            VirtualRunStage.SUSPENDED,
            VirtualRunStage.FAILED,
            VirtualRunStage.STOPPED,
            VirtualRunStage.DONE);

    /** Stages of a share whose own sentence the whole has to tell. */
    private static final Set<VirtualRunStage> EXPLAINED = EnumSet.of(
            VirtualRunStage.QUEUED, VirtualRunStage.GIVING_UP, VirtualRunStage.SUSPENDED, VirtualRunStage.FAILED);

    /** {@code runs}: one at least. */
    public static VirtualProgress of(List<VirtualRun> runs) {
        VirtualRunStage stage = TOLD.stream()
                .filter(one -> runs.stream().anyMatch(run -> run.stage() == one))
                .findFirst()
                .orElseThrow();
        int flown = runs.stream().mapToInt(VirtualRun::flown).sum();
        int total = runs.stream().mapToInt(VirtualRun::total).sum();
        int drones = (int) runs.stream().filter(run -> run.stage().isBound()).count();
        Instant changed = runs.stream()
                .map(VirtualRun::changedAt)
                .max(Comparator.naturalOrder())
                .orElseThrow();
        String sentence = runs.size() == 1 ? runs.get(0).note() : sentence(runs, stage, flown + " of " + total);
        return new VirtualProgress(stage, sentence, flown, total, drones, changed);
    }

    private static String sentence(List<VirtualRun> runs, VirtualRunStage stage, String waypoints) {
        if (stage == VirtualRunStage.DONE) {
            return "Done: all waypoints are flown, in " + runs.size() + " shares.";
        }
        String flown = waypoints + " waypoints are flown";
        if (stage == VirtualRunStage.STOPPED) {
            return "It was stopped: " + flown + ".";
        }
        List<String> parts = new ArrayList<>();
        count(parts, runs, "under way", run -> run.stage().isBound());
        count(parts, runs, "waiting for a drone", VirtualRun::isWaiting);
        count(parts, runs, "suspended", run -> run.stage() == VirtualRunStage.SUSPENDED);
        count(parts, runs, "failed", run -> run.stage() == VirtualRunStage.FAILED);
        count(parts, runs, "stopped", run -> run.stage() == VirtualRunStage.STOPPED);
        count(parts, runs, "done", run -> run.stage() == VirtualRunStage.DONE);
        return runs.size() + " shares: " + String.join(", ", parts) + "; " + flown + "." + explanations(runs);
    }

    private static void count(List<String> parts, List<VirtualRun> runs, String words, Predicate<VirtualRun> counts) {
        long count = runs.stream().filter(counts).count();
        if (count > 0) {
            parts.add(count + " " + words);
        }
    }

    private static String explanations(List<VirtualRun> runs) {
        StringBuilder words = new StringBuilder();
        IntStream.range(0, runs.size())
                .filter(share -> EXPLAINED.contains(runs.get(share).stage()))
                .forEach(share -> words.append(" Share ")
                        .append(share + 1)
                        .append(": ")
                        .append(runs.get(share).note()));
        return words.toString();
    }
}
