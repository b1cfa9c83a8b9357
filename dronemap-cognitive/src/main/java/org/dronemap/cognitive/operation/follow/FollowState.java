package org.dronemap.cognitive.operation.follow;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.operation.ChosenDrone;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * The state of a phone follow: its order, stage, command under way and notices; stored with each decision.
 *
 * @param since when it came to this stage
 * @param waitsSince from when on positions are waited for
 * @param issuedCommand the command that is under way
 * @param attempts how it went with the present step
 * @param missingFix why the phone's positions do not come; null: they do
 * @param note what is not as it should be, as a sentence
 * @param notices the newest {@value #MOST_TOLD}, oldest first
 * @param end how it ended, as a sentence; null: it goes on
 * @param reliefState the other drones; null: there were none yet
 */
@Stored(names = "id order stage since waits errand tries missing note told end relay")
public record FollowState(
        OperationId id,
        FollowOrder order,
        FollowStage stage,
        Instant since,
        Instant waitsSince,
        @Nullable IssuedCommand issuedCommand,
        Attempts attempts,
        @Nullable MissingFixReason missingFix,
        @Nullable String note,
        List<Notice> notices,
        @Nullable String end,
        @Nullable ReliefState reliefState) {
    public static final int MOST_TOLD = 30;

    public FollowState {
        notices = List.copyOf(notices);
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
    FollowState relief(ChosenDrone chosen, Instant at) {
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
                ReliefState.ofNumber(reliefOrNone().sent() + 1));
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

    public ReliefState reliefOrNone() {
        return reliefState == null ? ReliefState.NONE : reliefState;
    }

    /** On its way to take over from the drone that leads. */
    public boolean isComing(FollowState leader) {
        return reliefOrNone().number() > leader.reliefOrNone().number()
                && (stage == FollowStage.STARTING || stage == FollowStage.TRACKING);
    }

    /** That one took over from it. */
    boolean wasReplacedBy(FollowState leader) {
        return reliefOrNone().number() < leader.reliefOrNone().number();
    }

    /** A drone is on its way to take over. */
    public boolean isRelieved() {
        return reliefOrNone().others().stream().anyMatch(other -> other.isComing(this));
    }

    /** Another drone could take over, if there were one. */
    public boolean isRelievable() {
        boolean leads = stage == FollowStage.TRACKING && missingFix == null;
        return (leads || (stage == FollowStage.RETURNING && reliefOrNone().vacant())) && !isRelieved();
    }

    FollowState to(FollowStage next, Instant at, String words) {
        List<Notice> all = appendNotice(at, words);
        return new FollowState(
                id,
                order,
                next,
                at,
                at,
                null,
                new Attempts(attempts.given(), 0, null),
                null,
                null,
                all,
                next == FollowStage.OVER ? words : null,
                reliefState == null ? null : reliefState.vacant(false));
    }

    /** It leads from then on, in the place of the one that led before. */
    FollowState assumeLead(FollowState before, Instant at, ReliefState crew) {
        return new FollowState(
                id, order, stage, at, at, issuedCommand, attempts, missingFix, note, before.notices(), null, crew);
    }

    /** It says so, and is reached or not from then on. */
    FollowState missingFix(@Nullable MissingFixReason why, Instant at, String words, @Nullable String noted) {
        return new FollowState(
                id,
                order,
                stage,
                since,
                waitsSince,
                issuedCommand,
                attempts,
                why,
                noted,
                appendNotice(at, words),
                end,
                reliefState);
    }

    FollowState withNotice(Instant at, String words) {
        return new FollowState(
                id,
                order,
                stage,
                since,
                waitsSince,
                issuedCommand,
                attempts,
                missingFix,
                note,
                appendNotice(at, words),
                end,
                reliefState);
    }

    private List<Notice> appendNotice(Instant at, String words) {
        List<Notice> all = new ArrayList<>(notices);
        all.add(new Notice(at, words));
        return all.subList(Math.max(0, all.size() - MOST_TOLD), all.size());
    }

    /** What it said was passed on. */
    FollowState withoutNotices() {
        return new FollowState(
                id,
                order,
                stage,
                since,
                waitsSince,
                issuedCommand,
                attempts,
                missingFix,
                note,
                List.of(),
                end,
                reliefState);
    }

    FollowState with(FollowOrder other) {
        return new FollowState(
                id,
                other,
                stage,
                since,
                waitsSince,
                issuedCommand,
                attempts,
                missingFix,
                note,
                notices,
                end,
                reliefState);
    }

    FollowState with(@Nullable ReliefState other) {
        return new FollowState(
                id, order, stage, since, waitsSince, issuedCommand, attempts, missingFix, note, notices, end, other);
    }

    FollowState noted(@Nullable String what) {
        return new FollowState(
                id,
                order,
                stage,
                since,
                waitsSince,
                issuedCommand,
                attempts,
                missingFix,
                what,
                notices,
                end,
                reliefState);
    }

    FollowState waiting(Instant from) {
        return new FollowState(
                id, order, stage, since, from, issuedCommand, attempts, missingFix, note, notices, end, reliefState);
    }

    FollowState withIssuedCommand(@Nullable IssuedCommand what, Attempts now) {
        return new FollowState(
                id, order, stage, since, waitsSince, what, now, missingFix, note, notices, end, reliefState);
    }
}
