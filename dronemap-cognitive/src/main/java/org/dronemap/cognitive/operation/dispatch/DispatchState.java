package org.dronemap.cognitive.operation.dispatch;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.operation.ChosenDrone;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * The state of a dispatch: its order, stage, drones and notices; stored with each decision.
 *
 * @param since when it came to this stage
 * @param restartedAt when the process was started again since it came to this stage; null: it was not
 * @param lead the drone that comes, or came; null: none does now
 * @param returning drones that fly home, or wait to be heard for that
 * @param failed drones that did not come, and are not sent again
 */
@Stored(names = "id order stage since restartedAt lead returning failed log")
public record DispatchState(
        OperationId id,
        DispatchOrder order,
        DispatchStage stage,
        Instant since,
        @Nullable Instant restartedAt,
        @Nullable DispatchLeg lead,
        List<DispatchLeg> returning,
        List<DroneId> failed,
        Log log) {
    public static final int MOST_TOLD = 30;

    public DispatchState {
        returning = List.copyOf(returning);
        failed = List.copyOf(failed);
    }

    /** A text that users were shown, with its time. */
    @Stored(names = "at words")
    public record Notice(Instant at, String words) {}

    /**
     * Texts of a dispatch for users.
     *
     * @param notices the newest {@value DispatchState#MOST_TOLD}, oldest first
     * @param note what is not as it should be now, as a sentence; null: nothing
     * @param end why no drone comes any more, or how it ended, as a sentence; null: it goes on
     */
    @Stored(names = "told note end")
    public record Log(
            List<Notice> notices,
            @Nullable String note,
            @Nullable String end) {
        public Log {
            notices = List.copyOf(notices);
        }

        private Log with(Instant at, String words) {
            List<Notice> all = new ArrayList<>(notices);
            all.add(new Notice(at, words));
            return new Log(all.subList(Math.max(0, all.size() - MOST_TOLD), all.size()), note, end);
        }
    }

    /** A drone is there for it. */
    public static DispatchState begin(OperationId id, DispatchOrder order, ChosenDrone chosen, Instant at) {
        Log why = new Log(List.of(new Notice(at, chosen.why())), null, null);
        return new DispatchState(
                id, order, DispatchStage.CHOSEN, at, null, DispatchLeg.of(chosen, 0), List.of(), List.of(), why);
    }

    public boolean isOver() {
        return stage == DispatchStage.OVER;
    }

    /** Another drone is looked for, which may be any but these. */
    public boolean isSearching() {
        return stage == DispatchStage.SEARCHING;
    }

    /** The drone that comes or came, by its name; empty: there is none now. */
    public Optional<String> leadName() {
        return Optional.ofNullable(lead).map(DispatchLeg::name);
    }

    DispatchState to(DispatchStage next, Instant at, String words) {
        return new DispatchState(
                id,
                order,
                next,
                at,
                null,
                lead,
                returning,
                failed,
                withoutNote(log).with(at, words));
    }

    private static Log withoutNote(Log log) {
        return new Log(log.notices(), null, log.end());
    }

    /** No drone comes any more; over as soon as nobody has to fly home. */
    DispatchState end(Instant at, String words) {
        DispatchState next = to(DispatchStage.RETURNING, at, words).withLead(null);
        return next.with(new Log(next.log.notices(), null, words)).overIfAllAreHome();
    }

    DispatchState overIfAllAreHome() {
        boolean over = stage == DispatchStage.RETURNING && returning.isEmpty();
        return over
                ? new DispatchState(
                        id, order, DispatchStage.OVER, since, restartedAt, lead, returning, failed, withoutNote(log))
                : this;
    }

    DispatchState withLead(@Nullable DispatchLeg other) {
        return new DispatchState(id, order, stage, since, restartedAt, other, returning, failed, log);
    }

    DispatchState withReturning(List<DispatchLeg> legs) {
        return new DispatchState(id, order, stage, since, restartedAt, lead, legs, failed, log);
    }

    /** The drone that came flies home from now on. */
    DispatchState withLeadReturning() {
        if (lead == null) {
            return this;
        }
        List<DispatchLeg> legs = new ArrayList<>(returning);
        legs.add(lead.anew());
        return withReturning(legs).withLead(null);
    }

    DispatchState failing(DroneId drone) {
        List<DroneId> all = new ArrayList<>(failed);
        all.add(drone);
        return new DispatchState(id, order, stage, since, restartedAt, lead, returning, all, log);
    }

    DispatchState restarted(@Nullable Instant at) {
        return new DispatchState(id, order, stage, since, at, lead, returning, failed, log);
    }

    private DispatchState with(Log other) {
        return new DispatchState(id, order, stage, since, restartedAt, lead, returning, failed, other);
    }

    DispatchState noted(@Nullable String what) {
        return with(new Log(log.notices(), what, log.end()));
    }

    DispatchState withNotice(Instant at, String words) {
        return with(log.with(at, words));
    }
}
