package org.dronemap.core.cloud;

import java.time.Clock;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;
import org.dronemap.core.access.Principal;
import org.dronemap.core.audit.AuditedCall;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.cloud.rule.ControlRules;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.lease.ClockReading;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.lease.ControlState;
import org.dronemap.core.lease.LapsedLease;
import org.dronemap.core.lease.Lease;
import org.dronemap.core.lease.LeaseAnswer;
import org.dronemap.core.lease.LeaseDenial;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.core.lease.LeaseMachine;
import org.dronemap.core.lease.LeaseStep;
import org.dronemap.core.lease.LeaseStore;
import org.dronemap.core.lease.SavedLease;
import org.jspecify.annotations.Nullable;

/**
 * Holds who controls one drone: applies lease events, stores leases, and blocks sending by former holders. Any thread:
 * decisions and sendings exclude each other by its monitor, under which nobody waits.
 */
final class DroneControl {
    private final DroneId drone;
    private final LeaseMachine machine;
    private final Persistence keeping;
    private final Clock clock;
    private final LongSupplier nanoTime;
    private Announcer announcer = (control, changes) -> {};
    private volatile ControlState control;
    private volatile @Nullable String mode;

    /** Store of control leases, and the thread that writes their changes in order. */
    record Persistence(LeaseStore store, StoreWriter journal) {}

    /** Hears in order of what happened, under the monitor; must return at once. */
    interface Announcer {
        void changed(ControlState now, List<ControlChange> changes);
    }

    /** A decision, and when what it changed is durable. */
    record Decision(LeaseStep step, CompletableFuture<Void> durable) {}

    DroneControl(DroneId drone, LeaseMachine machine, Persistence keeping, Clock clock, LongSupplier nanoTime) {
        this.drone = drone;
        this.machine = machine;
        this.keeping = keeping;
        this.clock = clock;
        this.nanoTime = nanoTime;
        this.control = ControlState.FREE;
    }

    synchronized void restore(SavedLease lease) {
        mode = lease.mode();
        control = machine.restored(lease, now());
    }

    synchronized void announceTo(Announcer listener) {
        announcer = listener;
    }

    ControlState control() {
        return control;
    }

    /** The mode that it flew in, by the will of this cloud, when that was last seen; null: not known. */
    @Nullable
    String mode() {
        return mode;
    }

    /** It flies in that mode by the will of this cloud: kept, so that who takes it while the process is away is seen. */
    void flies(String now) {
        if (!now.equals(mode)) {
            keepMode(now);
        }
    }

    private synchronized void keepMode(String now) {
        SavedLease before = saved(control);
        mode = now;
        CompletableFuture<Void> unused = keep(before, saved(control));
    }

    synchronized Decision apply(LeaseEvent event) {
        // A sign of the holder that comes too late, as after this process stood still, is none.
        if (event instanceof LeaseEvent.ByUser sign
                && control.isHeldBy(sign.user())
                && machine.isSilent(control, nanoTime.getAsLong())) {
            Decision unused = apply(new LeaseEvent.TimeAdvanced(false, false));
        }
        ControlState before = control;
        LeaseStep step = machine.apply(before, event, now());
        control = step.control();
        AuditedCall.current().ifPresent(call -> call.epoch(drone.value(), epoch()));
        // The record of the call is that of the command, and not of the control that comes with it.
        boolean withACommand = event instanceof LeaseEvent.Command || event instanceof LeaseEvent.Interrupt;
        CompletableFuture<Void> durable = withACommand
                ? AuditedCall.beside(() -> keep(saved(before), saved(step.control())))
                : keep(saved(before), saved(step.control()));
        if (!step.changes().isEmpty()
                || before.requests().size() != step.control().requests().size()) {
            announcer.changed(step.control(), step.changes());
        }
        return new Decision(step, durable);
    }

    /**
     * Asks for the control that a command needs, and takes it where it is free; operations have it, or command nothing, and
     * lose it to whoever answers for safety.
     */
    synchronized ControlClearance enter(CommandGate.Source source, Command command) {
        if (source.operation() == null && ControlRules.onlyReads(command)) {
            return new ControlClearance.Cleared(epoch(), EpochGuard.NONE);
        }
        ControlClearance passage = enter(source);
        boolean first = passage instanceof ControlClearance.Refused
                && source.operation() == null
                && ControlRules.isOpenTo(source.principal(), drone, command);
        if (!first) {
            return passage;
        }
        interrupt(source.principal(), command);
        return new ControlClearance.Cleared(epoch(), EpochGuard.NONE);
    }

    /** Asks for control as it is, and takes it where it is free. */
    synchronized ControlClearance enter(CommandGate.Source source) {
        LeaseHolder.Operation operation = source.operation();
        if (operation != null) {
            return enter(operation);
        }
        LeaseAnswer answer = apply(new LeaseEvent.Command(source.principal().name(), source.epoch()))
                .step()
                .answer();
        return answer instanceof LeaseAnswer.Denied denied ? closed(denied) : fenced();
    }

    private static ControlClearance closed(LeaseAnswer.Denied denied) {
        return denied.reason() == LeaseDenial.ENDED
                ? new ControlClearance.Refused(new Refusal(OutcomeCode.CONTROL_ENDED, denied.why()))
                : held(denied.why());
    }

    private static ControlClearance held(String sentence) {
        return new ControlClearance.Refused(new Refusal(OutcomeCode.CONTROL_HELD, sentence));
    }

    private ControlClearance enter(LeaseHolder.Operation operation) {
        Lease tenure = control.tenure();
        return tenure != null && tenure.holder().isOperation(operation.id()) ? fenced() : held(control.sentence());
    }

    /** For what a rule of safety commands; empty when somebody has control, other than by this epoch. */
    synchronized Optional<ControlClearance.Cleared> enterForSafety(
            Principal rule, Command command, @Nullable Long epoch) {
        boolean goesOn = epoch != null && epoch == control.epoch();
        if (control.tenure() != null && !goesOn) {
            return Optional.empty();
        }
        interrupt(rule, command);
        return Optional.of(fenced());
    }

    /** For what a rule does while nobody has control, and only as long as nobody takes it; empty when somebody has. */
    synchronized Optional<ControlClearance.Cleared> enterWhileFree() {
        return control.tenure() == null ? Optional.of(fenced()) : Optional.empty();
    }

    private void interrupt(Principal by, Command command) {
        apply(new LeaseEvent.Interrupt(by.name() + " told the drone: " + command.summary() + "."));
    }

    private ControlClearance.Cleared fenced() {
        long epoch = control.epoch();
        return new ControlClearance.Cleared(epoch == 0 ? null : (Long) epoch, send -> passes(epoch, send));
    }

    private synchronized boolean passes(long epoch, Runnable send) {
        if (control.epoch() != epoch) {
            return false;
        }
        send.run();
        return true;
    }

    /** Lets time go by; {@code busy} is asked only when it matters. */
    void advance(BooleanSupplier busy, boolean heard, boolean hurries) {
        LapsedLease lapse = control.lapse();
        if (machine.isDue(control, nanoTime.getAsLong()) || (hurries && lapse != null && !lapse.returned())) {
            apply(new LeaseEvent.TimeAdvanced(busy.getAsBoolean(), heard, hurries));
        }
    }

    private @Nullable Long epoch() {
        long epoch = control.epoch();
        return epoch == 0 ? null : (Long) epoch;
    }

    private ClockReading now() {
        return new ClockReading(clock.instant(), nanoTime.getAsLong());
    }

    private @Nullable SavedLease saved(ControlState of) {
        LapsedLease lapse = of.lapse();
        if (lapse != null) {
            return new SavedLease(drone, lapse.user(), lapse.at(), of.epoch(), true, mode);
        }
        return of.tenure() != null && of.tenure().holder() instanceof LeaseHolder.Person person
                ? new SavedLease(
                        drone,
                        person.name(),
                        of.tenure().since(),
                        of.epoch(),
                        !of.tenure().explicit(),
                        mode)
                : null;
    }

    private CompletableFuture<Void> keep(@Nullable SavedLease before, @Nullable SavedLease now) {
        if (before == null ? now == null : before.equals(now)) {
            return CompletableFuture.completedFuture(null);
        }
        return keeping.journal().written("who has control of " + drone, () -> {
            if (now == null) {
                keeping.store().delete(drone);
            } else {
                keeping.store().save(now);
            }
        });
    }
}
