package org.dronemap.core.lease;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.LongSupplier;
import org.dronemap.core.lease.ControlChange.Kind;
import org.jspecify.annotations.Nullable;

/**
 * State machine of who controls a drone: from a control state and an event to the next control state. It touches
 * nothing but the supply of epochs, which must rise. Any thread.
 */
public final class LeaseMachine {
    private static final int MOST_REQUESTS = 20;
    /** As long as clients take to come back after a restart, or to see that control was given to them. */
    private static final long RETURNING_NANOS = 15_000_000_000L;

    private final LeaseRules rules;
    private final LongSupplier epochs;

    public LeaseMachine(LeaseRules rules, LongSupplier epochs) {
        this.rules = rules;
        this.epochs = epochs;
    }

    /**
     * An explicit holder of an earlier process, who gets time to come back; or one who was lost in that, and then the time
     * until the return begins anew. The epoch is a new one.
     */
    public ControlState restored(SavedLease lease, ClockReading now) {
        if (lease.lapsed()) {
            return freed(epochs.getAsLong(), new LapsedLease(lease.user(), lease.since(), now.nanos(), false));
        }
        Lease tenure = new Lease(
                new LeaseHolder.Person(lease.user()),
                true,
                lease.since(),
                now.nanos() + RETURNING_NANOS,
                lease.epoch());
        return new ControlState(epochs.getAsLong(), tenure, List.of(), null, null);
    }

    public LeaseStep apply(ControlState control, LeaseEvent event, ClockReading now) {
        if (event instanceof LeaseEvent.Command command) {
            return command(control, command, now);
        }
        if (event instanceof LeaseEvent.TimeAdvanced tick) {
            return advance(control, tick, now);
        }
        if (event instanceof LeaseEvent.Heartbeat heartbeat) {
            return heartbeat(control, heartbeat, now);
        }
        if (event instanceof LeaseEvent.TakeControl take) {
            return takeControl(control, take.user(), now);
        }
        if (event instanceof LeaseEvent.Request request) {
            return request(control, request, now);
        }
        if (event instanceof LeaseEvent.TakeOver takeOver) {
            return takeOver(control, takeOver, now);
        }
        return ofHolderOrPilot(control, event, now);
    }

    private LeaseStep ofHolderOrPilot(ControlState control, LeaseEvent event, ClockReading now) {
        if (event instanceof LeaseEvent.Grant grant) {
            return grant(control, grant, now);
        }
        if (event instanceof LeaseEvent.Refuse refuse) {
            return refuse(control, refuse);
        }
        if (event instanceof LeaseEvent.HandOver handOver) {
            return handOver(control, handOver.user(), handOver.to(), now);
        }
        if (event instanceof LeaseEvent.Release release) {
            return release(control, release.user(), now);
        }
        if (event instanceof LeaseEvent.Expel expel) {
            return expel(control, expel.user(), now);
        }
        if (event instanceof LeaseEvent.Engage engage) {
            return engage(control, engage.by(), now);
        }
        if (event instanceof LeaseEvent.Disengage disengage) {
            return disengage(control, disengage, now);
        }
        if (event instanceof LeaseEvent.Interrupt interrupt) {
            return interrupt(control, interrupt.why(), now);
        }
        if (event instanceof LeaseEvent.Landed) {
            return LeaseStep.granted(control.withoutLapse());
        }
        if (event instanceof LeaseEvent.PilotActed pilot) {
            return pilotActed(control, pilot.what(), now);
        }
        return pilotLeft(control);
    }

    private LeaseStep command(ControlState control, LeaseEvent.Command command, ClockReading now) {
        Lease tenure = control.tenure();
        boolean holds = control.isHeldBy(command.user());
        if (command.epoch() != null && !control.isHeldBy(command.user(), command.epoch())) {
            return LeaseStep.denied(
                    control,
                    LeaseDenial.ENDED,
                    "Control by epoch " + command.epoch() + " has ended. " + control.sentence());
        }
        if (tenure != null && !holds) {
            return LeaseStep.denied(control, LeaseDenial.HELD, control.sentence());
        }
        if (tenure != null) {
            return LeaseStep.granted(control.with(tenure.renewed(now)));
        }
        LeaseHolder holder = new LeaseHolder.Person(command.user());
        return LeaseStep.granted(begin(control, holder, false, now), change(Kind.TAKEN, holder, null));
    }

    private LeaseStep takeControl(ControlState control, String user, ClockReading now) {
        Lease tenure = control.tenure();
        LeaseHolder holder = new LeaseHolder.Person(user);
        if (tenure == null || tenure.holder() instanceof LeaseHolder.Pilot) {
            LeaseHolder before = tenure == null ? null : tenure.holder();
            return LeaseStep.granted(begin(control, holder, true, now), change(Kind.TAKEN, holder, before));
        }
        if (!tenure.holder().equals(holder)) {
            return LeaseStep.denied(control, LeaseDenial.HELD, control.sentence());
        }
        // Asked for again while it was explicit: from another window, and only one of them shall go on.
        ControlState kept = tenure.explicit() ? begin(control, holder, true, now) : control.with(tenure.kept(now));
        return LeaseStep.granted(kept, change(Kind.TAKEN, holder, null));
    }

    private LeaseStep request(ControlState control, LeaseEvent.Request request, ClockReading now) {
        Lease tenure = control.tenure();
        if (tenure == null || !(tenure.holder() instanceof LeaseHolder.Person) || control.isHeldBy(request.user())) {
            return takeControl(control, request.user(), now);
        }
        List<LeaseRequest> requests =
                new ArrayList<>(control.without(request.user()).requests());
        if (requests.size() >= MOST_REQUESTS) {
            return LeaseStep.denied(
                    control,
                    LeaseDenial.REQUESTS_FULL,
                    "Too many have asked for control already. " + control.sentence());
        }
        requests.add(new LeaseRequest(request.user(), request.reason(), now.at(), now.nanos()));
        ControlChange asked = new ControlChange(
                Kind.REQUESTED, new LeaseHolder.Person(request.user()), tenure.holder(), request.reason());
        return new LeaseStep(control.withRequests(requests), new LeaseAnswer.Waiting(), List.of(asked));
    }

    private LeaseStep takeOver(ControlState control, LeaseEvent.TakeOver event, ClockReading now) {
        Lease tenure = control.tenure();
        if (tenure == null || control.isHeldBy(event.user())) {
            return takeControl(control, event.user(), now);
        }
        LeaseHolder holder = new LeaseHolder.Person(event.user());
        return LeaseStep.granted(
                begin(control, holder, true, now),
                new ControlChange(Kind.TAKEN_OVER, holder, tenure.holder(), event.reason()));
    }

    private LeaseStep grant(ControlState control, LeaseEvent.Grant grant, ClockReading now) {
        if (control.isHeldBy(grant.user()) && requestBy(control, grant.to()).isEmpty()) {
            return LeaseStep.denied(
                    control, LeaseDenial.NOT_ASKED, grant.to() + " does not ask for control (any more).");
        }
        return handOver(control, grant.user(), grant.to(), now);
    }

    private LeaseStep refuse(ControlState control, LeaseEvent.Refuse refuse) {
        Lease tenure = control.tenure();
        if (tenure == null || !control.isHeldBy(refuse.user())) {
            return notYours(control);
        }
        if (requestBy(control, refuse.to()).isEmpty()) {
            return LeaseStep.denied(
                    control, LeaseDenial.NOT_ASKED, refuse.to() + " does not ask for control (any more).");
        }
        return LeaseStep.granted(
                control.without(refuse.to()),
                new ControlChange(Kind.REFUSED, tenure.holder(), new LeaseHolder.Person(refuse.to()), refuse.reason()));
    }

    /** Implicit until the new holder acts: who gets it may not be looking. */
    private LeaseStep handOver(ControlState control, String user, String to, ClockReading now) {
        Lease tenure = control.tenure();
        if (tenure == null || !control.isHeldBy(user)) {
            return notYours(control);
        }
        if (to.equals(user)) {
            return LeaseStep.denied(control, LeaseDenial.OWN, "You have control already.");
        }
        LeaseHolder next = new LeaseHolder.Person(to);
        return LeaseStep.granted(begin(control, next, false, now), change(Kind.HANDED_OVER, tenure.holder(), next));
    }

    private LeaseStep heartbeat(ControlState control, LeaseEvent.Heartbeat heartbeat, ClockReading now) {
        Lease tenure = control.tenure();
        if (tenure == null || !control.isHeldBy(heartbeat.user(), heartbeat.epoch())) {
            return LeaseStep.denied(
                    control,
                    LeaseDenial.ENDED,
                    "Control by epoch " + heartbeat.epoch() + " has ended. " + control.sentence());
        }
        if (!tenure.explicit()) {
            return LeaseStep.denied(
                    control,
                    LeaseDenial.NOT_TAKEN,
                    "Take control first: this one came with a command and needs no heartbeat.");
        }
        return LeaseStep.granted(control.with(tenure.renewed(now)));
    }

    private static LeaseStep release(ControlState control, String user, ClockReading now) {
        Lease tenure = control.tenure();
        if (tenure == null || !control.isHeldBy(user)) {
            return notYours(control);
        }
        return LeaseStep.granted(
                freed(control.epoch(), lapse(user, now)), change(Kind.RELEASED, tenure.holder(), null));
    }

    private LeaseStep expel(ControlState control, String user, ClockReading now) {
        ControlState rest = control.without(user);
        Lease tenure = rest.tenure();
        if (tenure == null || !rest.isHeldBy(user)) {
            return LeaseStep.granted(rest);
        }
        return LeaseStep.granted(
                freed(epochs.getAsLong(), lapse(user, now)), change(Kind.EXPELLED, tenure.holder(), null));
    }

    private LeaseStep engage(ControlState control, LeaseHolder.Operation operation, ClockReading now) {
        Lease tenure = control.tenure();
        if (tenure != null) {
            return tenure.holder().isOperation(operation.id())
                    ? LeaseStep.granted(control)
                    : LeaseStep.denied(control, LeaseDenial.HELD, control.sentence());
        }
        return LeaseStep.granted(begin(control, operation, true, now), change(Kind.TAKEN, operation, null));
    }

    private LeaseStep disengage(ControlState control, LeaseEvent.Disengage event, ClockReading now) {
        Lease tenure = control.tenure();
        if (tenure == null || !tenure.holder().isOperation(event.operation())) {
            return LeaseStep.granted(control);
        }
        if (event.to() != null) {
            LeaseHolder next = new LeaseHolder.Person(event.to());
            ClockReading later = new ClockReading(now.at(), now.nanos() + RETURNING_NANOS);
            return LeaseStep.granted(
                    begin(control, next, true, later), change(Kind.HANDED_OVER, tenure.holder(), next));
        }
        String user = tenure.holder().userName().orElseThrow();
        return LeaseStep.granted(
                freed(control.epoch(), lapse(user, now)), change(Kind.RELEASED, tenure.holder(), null));
    }

    /** With a new epoch: what the operation has sent and is not at the vehicle yet must not undo what interrupts it. */
    private LeaseStep interrupt(ControlState control, String why, ClockReading now) {
        Lease tenure = control.tenure();
        return tenure != null && tenure.holder() instanceof LeaseHolder.Operation holder
                ? LeaseStep.granted(
                        new ControlState(epochs.getAsLong(), null, List.of(), lapse(holder.user(), now), why),
                        change(Kind.RELEASED, holder, null))
                : LeaseStep.granted(control);
    }

    private LeaseStep pilotActed(ControlState control, String what, ClockReading now) {
        Lease tenure = control.tenure();
        if (tenure == null) {
            // Nobody here is in the way; but a pilot is there now, whom no rule shall call back.
            return LeaseStep.granted(freed(control.epoch(), null));
        }
        if (tenure.holder() instanceof LeaseHolder.Pilot) {
            return LeaseStep.granted(control.with(tenure.renewed(now)));
        }
        LeaseHolder pilot = new LeaseHolder.Pilot();
        return LeaseStep.granted(
                begin(control, pilot, true, now), new ControlChange(Kind.PILOT_ACTED, pilot, tenure.holder(), what));
    }

    private static LeaseStep pilotLeft(ControlState control) {
        Lease tenure = control.tenure();
        if (tenure == null || !(tenure.holder() instanceof LeaseHolder.Pilot)) {
            return LeaseStep.granted(control);
        }
        return LeaseStep.granted(freed(control.epoch(), null), change(Kind.PILOT_LEFT, tenure.holder(), null));
    }

    /** Whether time alone changes anything by now. */
    public boolean isDue(ControlState control, long nowNanos) {
        Lease tenure = control.tenure();
        boolean over = tenure != null
                && tenure.holder() instanceof LeaseHolder.Person
                && nowNanos - tenure.renewedNanos() > patienceNanos(tenure);
        return over
                || isReturnDue(control, nowNanos, false)
                || control.requests().stream().anyMatch(request -> isOld(request, nowNanos));
    }

    /** Whether its holder, who keeps control by signs, gave none for too long. */
    public boolean isSilent(ControlState control, long nowNanos) {
        Lease tenure = control.tenure();
        return tenure != null
                && tenure.explicit()
                && tenure.holder() instanceof LeaseHolder.Person
                && nowNanos - tenure.renewedNanos() > patienceNanos(tenure);
    }

    private long patienceNanos(Lease tenure) {
        return (tenure.explicit() ? rules.silence() : rules.idle()).toNanos();
    }

    private boolean isOld(LeaseRequest request, long nowNanos) {
        return nowNanos - request.nanos() > rules.asking().toNanos();
    }

    private boolean isReturnDue(ControlState control, long nowNanos, boolean hurries) {
        LapsedLease lapse = control.lapse();
        return lapse != null
                && !lapse.returned()
                && rules.onLoss() == LeaseRules.OnLoss.RETURN
                && (hurries
                        || nowNanos - lapse.sinceNanos() >= rules.untilReturn().toNanos());
    }

    private LeaseStep advance(ControlState control, LeaseEvent.TimeAdvanced tick, ClockReading now) {
        ControlState rest = control.withRequests(control.requests().stream()
                .filter(request -> !isOld(request, now.nanos()))
                .toList());
        Lease tenure = rest.tenure();
        if (tenure == null) {
            return tick.linkLive() && isReturnDue(rest, now.nanos(), tick.returnNow())
                    ? returning(rest)
                    : LeaseStep.granted(rest);
        }
        if (!(tenure.holder() instanceof LeaseHolder.Person person)) {
            return LeaseStep.granted(rest);
        }
        if (tick.busy() && !tenure.explicit()) {
            return LeaseStep.granted(rest.with(tenure.renewed(now)));
        }
        if (now.nanos() - tenure.renewedNanos() <= patienceNanos(tenure)) {
            return LeaseStep.granted(rest);
        }
        LapsedLease lapse = lapse(person.name(), now);
        return tenure.explicit()
                ? LeaseStep.granted(freed(epochs.getAsLong(), lapse), change(Kind.LOST, person, null))
                : LeaseStep.granted(freed(rest.epoch(), lapse), change(Kind.EXPIRED, person, null));
    }

    private static LeaseStep returning(ControlState control) {
        LapsedLease lapse = Objects.requireNonNull(control.lapse());
        LapsedLease returned = new LapsedLease(lapse.user(), lapse.at(), lapse.sinceNanos(), true);
        return LeaseStep.granted(
                new ControlState(control.epoch(), null, control.requests(), returned, null),
                change(Kind.RETURN_DUE, new LeaseHolder.Person(lapse.user()), null));
    }

    private ControlState begin(ControlState before, LeaseHolder holder, boolean explicit, ClockReading now) {
        List<LeaseRequest> others = holder instanceof LeaseHolder.Person person
                ? before.without(person.name()).requests()
                : List.of();
        Lease tenure = new Lease(holder, explicit, now.at(), now.nanos(), null);
        return new ControlState(epochs.getAsLong(), tenure, others, null, null);
    }

    /** However control ends: what is in the air then is nobody's, and comes home unless somebody takes it. */
    private static LapsedLease lapse(String user, ClockReading now) {
        return new LapsedLease(user, now.at(), now.nanos(), false);
    }

    /** Whoever waited can take it now. */
    private static ControlState freed(long epoch, @Nullable LapsedLease lapse) {
        return new ControlState(epoch, null, List.of(), lapse, null);
    }

    private static ControlChange change(Kind kind, LeaseHolder by, @Nullable LeaseHolder other) {
        return new ControlChange(kind, by, other, null);
    }

    private static Optional<LeaseRequest> requestBy(ControlState control, String user) {
        return control.requests().stream()
                .filter(request -> request.by().equals(user))
                .findFirst();
    }

    private static LeaseStep notYours(ControlState control) {
        return LeaseStep.denied(control, LeaseDenial.NOT_HELD, "You do not have control. " + control.sentence());
    }
}
