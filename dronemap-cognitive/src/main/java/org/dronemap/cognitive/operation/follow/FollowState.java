package org.dronemap.cognitive.operation.follow;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * The state of a phone follow: its order, stage, command under way and notices; stored with each decision.
 *
 * @param since when it came to this stage
 * @param waits from when on positions are waited for
 * @param errand the command that is under way
 * @param tries how it went with the present step
 * @param missing why the phone's positions do not come; null: they do
 * @param note what is not as it should be, as a sentence
 * @param told the newest {@value #MOST_TOLD}, oldest first
 * @param end how it ended, as a sentence; null: it goes on
 * @param relay the other drones; null: there were none yet
 */
@Stored(names = "id order stage since waits errand tries missing note told end relay")
public record FollowState(
        OperationId id,
        FollowOrder order,
        FollowStage stage,
        Instant since,
        Instant waits,
        @Nullable IssuedCommand errand,
        Attempts tries,
        @Nullable MissingFixReason missing,
        @Nullable String note,
        List<Notice> told,
        @Nullable String end,
        @Nullable ReliefState relay) {
    public static final int MOST_TOLD = 30;

    public FollowState {
        told = List.copyOf(told);
    }

    /** A text that users were shown, with its time. */
    @Stored(names = "at words")
    public record Notice(Instant at, String words) {}

    /** A command that the drone was given. */
    @Stored(names = "command kind")
    public record IssuedCommand(CommandId command, Purpose kind) {
        /** The purpose of the command. */
        @Stored(names = "CLOUD_LOSS MODE ARM TAKE_OFF HOME DISARM")
        public enum Purpose {
            CLOUD_LOSS,
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
    @Stored(names = "given failed notBefore")
    public record Attempts(int given, int failed, @Nullable Instant notBefore) {
        static final Attempts NONE = new Attempts(0, 0, null);
    }

    /** A drone is there for it. */
    public static FollowState begin(OperationId id, FollowOrder order, Instant at) {
        List<Notice> why = List.of(new Notice(at, order.chosen().why()));
        return new FollowState(
                id, order, FollowStage.ALLOCATED, at, at, null, Attempts.NONE, null, null, why, null, null);
    }

    /** One that comes to replace the drone of this follow. */
    FollowState relief(FollowOrder.ChosenDrone chosen, Instant at) {
        return new FollowState(
                id,
                order.by(chosen),
                FollowStage.STARTING,
                at,
                at,
                null,
                Attempts.NONE,
                null,
                null,
                List.of(),
                null,
                ReliefState.ofNumber(crew().sent() + 1));
    }

    public DroneId drone() {
        return order.chosen().drone();
    }

    /** As people call its drone. */
    public String droneName() {
        return order.chosen().name();
    }

    public boolean isOver() {
        return stage == FollowStage.OVER;
    }

    public ReliefState crew() {
        return relay == null ? ReliefState.NONE : relay;
    }

    /** On its way to take over from the drone that leads. */
    public boolean comes(FollowState leader) {
        return crew().number() > leader.crew().number()
                && (stage == FollowStage.STARTING || stage == FollowStage.TRACKING);
    }

    /** That one took over from it. */
    boolean wasReplacedBy(FollowState leader) {
        return crew().number() < leader.crew().number();
    }

    /** A drone is on its way to take over. */
    public boolean isRelieved() {
        return crew().others().stream().anyMatch(other -> other.comes(this));
    }

    /** Another drone could take over, if there were one. */
    public boolean isRelievable() {
        boolean leads = stage == FollowStage.TRACKING && missing == null;
        return (leads || (stage == FollowStage.RETURNING && crew().vacant())) && !isRelieved();
    }

    FollowState to(FollowStage next, Instant at, String words) {
        List<Notice> all = telling(at, words);
        return new FollowState(
                id,
                order,
                next,
                at,
                at,
                null,
                new Attempts(tries.given(), 0, null),
                null,
                null,
                all,
                next == FollowStage.OVER ? words : null,
                relay == null ? null : relay.vacant(false));
    }

    /** It leads from then on, in the place of the one that led before. */
    FollowState leads(FollowState before, Instant at, ReliefState crew) {
        return new FollowState(id, order, stage, at, at, errand, tries, missing, note, before.told(), null, crew);
    }

    /** It says so, and is reached or not from then on. */
    FollowState missing(@Nullable MissingFixReason why, Instant at, String words, @Nullable String noted) {
        return new FollowState(
                id, order, stage, since, waits, errand, tries, why, noted, telling(at, words), end, relay);
    }

    FollowState saying(Instant at, String words) {
        return new FollowState(
                id, order, stage, since, waits, errand, tries, missing, note, telling(at, words), end, relay);
    }

    private List<Notice> telling(Instant at, String words) {
        List<Notice> all = new ArrayList<>(told);
        all.add(new Notice(at, words));
        return all.subList(Math.max(0, all.size() - MOST_TOLD), all.size());
    }

    /** What it said was passed on. */
    FollowState silently() {
        return new FollowState(id, order, stage, since, waits, errand, tries, missing, note, List.of(), end, relay);
    }

    FollowState with(FollowOrder other) {
        return new FollowState(id, other, stage, since, waits, errand, tries, missing, note, told, end, relay);
    }

    FollowState with(@Nullable ReliefState other) {
        return new FollowState(id, order, stage, since, waits, errand, tries, missing, note, told, end, other);
    }

    FollowState noted(@Nullable String what) {
        return new FollowState(id, order, stage, since, waits, errand, tries, missing, what, told, end, relay);
    }

    FollowState waiting(Instant from) {
        return new FollowState(id, order, stage, since, from, errand, tries, missing, note, told, end, relay);
    }

    FollowState on(@Nullable IssuedCommand what, Attempts now) {
        return new FollowState(id, order, stage, since, waits, what, now, missing, note, told, end, relay);
    }
}
