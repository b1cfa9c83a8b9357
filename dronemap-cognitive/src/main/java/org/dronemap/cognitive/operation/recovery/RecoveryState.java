package org.dronemap.cognitive.operation.recovery;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * The state of a recovery: its order, stage and drones; stored with each decision.
 *
 * @param since when it came to this stage
 * @param notices for users, the newest {@value #MOST_TOLD}, oldest first
 * @param end how it ended, as a sentence; null: it goes on
 */
@Stored(names = "id order stage since legs told end")
public record RecoveryState(
        OperationId id,
        RecoveryOrder order,
        RecoveryStage stage,
        Instant since,
        List<RecoveryLeg> legs,
        List<Notice> notices,
        @Nullable String end) {
    public static final int MOST_TOLD = 40;
    /** Nobody waits for one that was not heard for so long: it flies home at its own height, or is down. */
    private static final Duration LONGEST_SILENT_WAIT = Duration.ofSeconds(60);

    public RecoveryState {
        legs = List.copyOf(legs);
        notices = List.copyOf(notices);
    }

    /** A text that users were shown, with its time. */
    @Stored(names = "at words")
    public record Notice(Instant at, String words) {}

    /** A drone that a recovery begins with; {@code highestMeters}: above its home, the most that it may fly home at. */
    public record Member(DroneId drone, String name, double highestMeters) {}

    public static RecoveryState begin(OperationId id, RecoveryOrder order, List<Member> members, Instant at) {
        List<RecoveryLeg> legs = new ArrayList<>();
        for (Member member : members) {
            legs.add(RecoveryLeg.of(member.drone(), member.name(), legs.size(), member.highestMeters()));
        }
        return new RecoveryState(id, order, RecoveryStage.STOPPING, at, legs, List.of(), null);
    }

    public boolean isOver() {
        return stage == RecoveryStage.OVER;
    }

    public Optional<RecoveryLeg> leg(DroneId drone) {
        return legs.stream().filter(leg -> leg.drone().equals(drone)).findFirst();
    }

    /** The drones that this one waits for before its next step. */
    public List<RecoveryLeg> waitsFor(RecoveryLeg leg, Instant now) {
        return leg.isOver() || leg.step().isMove()
                ? List.of()
                : waitsFor(leg, leg.step().next(), now);
    }

    List<RecoveryLeg> waitsFor(RecoveryLeg leg, RecoveryStep step, Instant now) {
        RecoverySlot slot = leg.slot();
        if (slot == null) {
            return List.of();
        }
        return slot.waits().stream()
                .filter(wait -> !step.isBefore(wait.step()))
                .flatMap(wait ->
                        leg(wait.other())
                                .filter(other ->
                                        isInTheWay(other, now) && other.step().isBefore(wait.reached()))
                                .stream())
                .distinct()
                .toList();
    }

    private static boolean isInTheWay(RecoveryLeg other, Instant now) {
        Instant silent = other.signs().silentSince();
        return !other.isOver()
                && (silent == null || Duration.between(silent, now).compareTo(LONGEST_SILENT_WAIT) < 0);
    }

    RecoveryState to(RecoveryStage next, Instant at) {
        return new RecoveryState(id, order, next, at, legs, notices, end);
    }

    RecoveryState with(List<RecoveryLeg> others) {
        return new RecoveryState(id, order, stage, since, others, notices, end);
    }

    RecoveryState with(RecoveryLeg leg) {
        return with(legs.stream()
                .map(one -> one.drone().equals(leg.drone()) ? leg : one)
                .toList());
    }

    RecoveryState noticed(Instant at, String words) {
        List<Notice> all = new ArrayList<>(notices);
        all.add(new Notice(at, words));
        return new RecoveryState(
                id, order, stage, since, legs, all.subList(Math.max(0, all.size() - MOST_TOLD), all.size()), end);
    }

    RecoveryState ended(String words) {
        return new RecoveryState(id, order, stage, since, legs, notices, words);
    }

    /** When all should be down, and some more: then nobody waits for anybody any longer. */
    boolean isOverdue(Instant now) {
        double planned = legs.stream()
                .flatMap(leg -> Optional.ofNullable(leg.slot()).stream())
                .mapToDouble(RecoverySlot::downSeconds)
                .max()
                .orElse(0);
        return stage == RecoveryStage.COMING_DOWN
                && Duration.between(since, now).toSeconds() > LONGER * planned + SPARE_SECONDS;
    }

    private static final double LONGER = 2;
    private static final double SPARE_SECONDS = 120;
}
