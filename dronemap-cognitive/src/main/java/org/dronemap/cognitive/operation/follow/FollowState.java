package org.dronemap.cognitive.operation.follow;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.operation.OperationId;
import org.jspecify.annotations.Nullable;

/**
 * All that a follow remembers.
 *
 * @param since when it came to this stage
 * @param waits from when on positions are waited for
 * @param errand the command that is under way
 * @param tries how it went with the present step
 * @param note what is not as it should be, as a sentence
 * @param told the newest {@value #MOST_TOLD}, oldest first
 * @param end how it ended, as a sentence; null: it goes on
 */
public record FollowState(
        OperationId id,
        FollowOrder order,
        Stage stage,
        Instant since,
        Instant waits,
        @Nullable Errand errand,
        Tries tries,
        @Nullable String note,
        List<Told> told,
        @Nullable String end) {
    public static final int MOST_TOLD = 30;

    public FollowState {
        told = List.copyOf(told);
    }

    /** What it said to people. */
    public record Told(Instant at, String words) {}

    /** A command that the drone was given. */
    public record Errand(CommandId command, Kind kind) {
        /** What it is for. */
        public enum Kind {
            MODE,
            ARM,
            TAKE_OFF,
            HOME,
            DISARM
        }
    }

    /**
     * Of all commands, and of those that failed in a row.
     *
     * @param given commands so far
     * @param failed in a row
     * @param notBefore nothing is tried before; null: it may be at once
     */
    public record Tries(int given, int failed, @Nullable Instant notBefore) {}

    /** A drone is there for it. */
    public static FollowState begin(OperationId id, FollowOrder order, Instant at) {
        return new FollowState(
                id,
                order,
                Stage.ALLOCATED,
                at,
                at,
                null,
                new Tries(0, 0, null),
                null,
                List.of(new Told(at, order.chosen().why())),
                null);
    }

    public DroneId drone() {
        return order.chosen().drone();
    }

    public boolean isOver() {
        return stage == Stage.OVER;
    }

    FollowState to(Stage next, Instant at, String words) {
        List<Told> all = new ArrayList<>(told);
        all.add(new Told(at, words));
        return new FollowState(
                id,
                order,
                next,
                at,
                at,
                null,
                new Tries(tries.given(), 0, null),
                null,
                all.subList(Math.max(0, all.size() - MOST_TOLD), all.size()),
                next == Stage.OVER ? words : null);
    }

    FollowState with(FollowOrder other) {
        return new FollowState(id, other, stage, since, waits, errand, tries, note, told, end);
    }

    FollowState noted(@Nullable String what) {
        return new FollowState(id, order, stage, since, waits, errand, tries, what, told, end);
    }

    FollowState waiting(Instant from) {
        return new FollowState(id, order, stage, since, from, errand, tries, note, told, end);
    }

    FollowState on(@Nullable Errand what, Tries now) {
        return new FollowState(id, order, stage, since, waits, what, now, note, told, end);
    }
}
