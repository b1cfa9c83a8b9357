package org.dronemap.core.cloud;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.RejectedExecutionException;
import org.dronemap.core.cloud.lane.Lane;
import org.dronemap.core.cloud.listener.CloudListener;
import org.dronemap.core.cloud.listener.UserPresence;
import org.dronemap.core.cloud.outlook.ControlMessages;
import org.dronemap.core.cloud.rule.CommandRules;
import org.dronemap.core.cloud.rule.FlightFacts;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.lease.ControlState;
import org.dronemap.core.lease.LapsedLease;
import org.dronemap.core.lease.Lease;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.core.lease.LeaseRules;
import org.dronemap.core.safety.BatteryEndurance;
import org.dronemap.core.safety.ReturnPlanner;
import org.dronemap.core.time.Time;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Carries out effects of control changes of one drone: cancels old commands, secures a drone that lost its holder.
 * Owned by the drone's lane.
 */
final class ControlWatch implements Lane.TimedTask {
    private static final Logger LOG = LoggerFactory.getLogger(ControlWatch.class);
    private static final long RHYTHM_NANOS = Duration.ofMillis(200).toNanos();

    private final ManagedDrone drone;
    private final CommandGate gate;
    private final LeaseRules rules;
    private final UserPresence onlookers;
    private final CloudListener listener;
    private final ReturnWatch returning;
    private final LinkWatch links;
    private final HoldOnControlLoss holding;
    private final OutlookWatch outlooks;
    private final ModeWatch modes;
    private final BatteryEndurance energy = new BatteryEndurance();
    private final Time time;
    private long lookedNanos;

    ControlWatch(
            ManagedDrone drone,
            CommandGate gate,
            LeaseRules rules,
            UserPresence onlookers,
            CloudListener listener,
            ReturnWatch returning,
            LinkWatch links,
            Time time) {
        this.drone = drone;
        this.gate = gate;
        this.rules = rules;
        this.onlookers = onlookers;
        this.listener = listener;
        this.returning = returning;
        this.links = links;
        this.holding = new HoldOnControlLoss(drone, gate, rules);
        this.outlooks = new OutlookWatch(drone, returning, rules, time);
        this.modes = new ModeWatch(drone, gate, time);
        this.time = time;
        this.lookedNanos = time.nanos() - RHYTHM_NANOS;
        drone.control().announceTo(this::announce);
    }

    /** Any thread; in order. */
    private void announce(ControlState now, List<ControlChange> changes) {
        try {
            drone.lane().execute(() -> changed(now, changes));
        } catch (RejectedExecutionException e) {
            LOG.error("The lane of {} had no room to hear that {}", drone.id(), changes, e);
        }
    }

    private void changed(ControlState now, List<ControlChange> changes) {
        gate.stopOutdated(drone);
        drone.setpoints().controlChanged();
        for (ControlChange change : changes) {
            answers(now, change);
            listener.controlChanged(drone.id(), now, change);
            String sentence = ControlMessages.of(change);
            boolean concerns = change.kind() != ControlChange.Kind.RETURN_DUE || drone.isUncontrolledInAir();
            if (sentence != null && concerns) {
                drone.publishMessage(
                        change.kind() == ControlChange.Kind.LOST ? Severity.WARNING : Severity.NOTICE,
                        sentence,
                        ControlMessages.user(change));
            }
            announceReturn(change);
            holding.act(change);
        }
        outlooks.update(drone.drone().state(), energy.secondsLeft());
        drone.news();
    }

    /**
     * A user who takes control on purpose, or an operation, answers for the drone from then on, also an operation that goes on
     * after a restart; what a pilot steers is the pilot's.
     */
    private void answers(ControlState now, ControlChange change) {
        boolean takes = change.kind() == ControlChange.Kind.TAKEN || change.kind() == ControlChange.Kind.TAKEN_OVER;
        Lease tenure = now.tenure();
        boolean byHand = FlightFacts.isSteeredManually(drone.drone().state());
        if (takes && tenure != null && tenure.explicit() && !byHand) {
            drone.commandedFromHere(true);
        } else if (byHand
                && change.kind() == ControlChange.Kind.RELEASED
                && change.by() instanceof LeaseHolder.Operation) {
            // No operation steers by sticks: it lets go since a pilot does.
            drone.commandedFromHere(false);
        }
    }

    private void announceReturn(ControlChange change) {
        boolean over = change.kind() == ControlChange.Kind.EXPIRED || change.kind() == ControlChange.Kind.RELEASED;
        if (over && rules.onLoss() == LeaseRules.OnLoss.RETURN && drone.isUncontrolledInAir()) {
            drone.publishMessage(
                    Severity.WARNING,
                    "Nobody has control of it now: it returns in "
                            + rules.untilReturn().toSeconds() + " s unless somebody takes control.");
        }
    }

    /** Stops what does not stand by itself when nobody steers it any more, unless somebody else flies it already. */
    static void holdIfMoving(CommandGate gate, ManagedDrone drone, @Nullable Long epoch) {
        DroneState state = drone.drone().state();
        Optional<Steering> by = state.capabilities().steering(state.mode());
        boolean goesOn = by.isEmpty() || by.get() == Steering.STICKS;
        if (goesOn && CommandRules.canHold(state) && gate.manoeuvre(drone).isEmpty()) {
            gate.submitForSafety(drone, new Command.Hold(), epoch);
        }
    }

    /** Before anybody acts on it. */
    void modeChanged() {
        pilot(drone.drone().state());
    }

    @Override
    public void advance() {
        DroneState state = drone.drone().state();
        pilot(state);
        holding.actOnMissed();
        boolean due = time.nanos() - lookedNanos >= RHYTHM_NANOS;
        if (due) {
            lookedNanos = time.nanos();
            energy.observe(state, lookedNanos);
        }
        OptionalDouble left = energy.secondsLeft();
        boolean inMission = FlightFacts.isFlying(state) && FlightFacts.isInMission(state);
        drone.control()
                .advance(
                        () -> gate.isBusy(drone) || isWatched(state),
                        FlightFacts.areKnown(state) && !inMission && !links.tries(),
                        due && drone.isUncontrolledInAir() && ReturnPlanner.hurries(state, left, RHYTHM_NANOS / 1e9));
        if (due) {
            keepMode(state);
            links.update(state);
            bringHome(state, left);
            outlooks.lookAgain(state, left);
        }
    }

    private void pilot(DroneState state) {
        ControlState control = drone.control().control();
        boolean down = FlightFacts.isDown(state);
        String foreign = modes.foreign(state);
        if (control.tenure() != null && control.tenure().holder() instanceof LeaseHolder.Pilot) {
            if (Boolean.FALSE.equals(state.armed())) {
                drone.control().apply(new LeaseEvent.PilotLeft());
            }
        } else if (foreign != null) {
            drone.commandedFromHere(false);
            drone.control().apply(new LeaseEvent.PilotActed(foreign));
        }
        isWhose(state, down);
    }

    private void isWhose(DroneState state, boolean down) {
        // One that drives is never anything but down.
        if (down && (CommandRules.needsAir(state) || Boolean.FALSE.equals(state.armed()))) {
            drone.commandedFromHere(false);
        }
        if (down && drone.control().control().lapse() != null) {
            drone.control().apply(new LeaseEvent.Landed());
        }
    }

    /** No oftener than it is looked at: a vehicle that changes its mode all the time does not fill the journal. */
    private void keepMode(DroneState state) {
        String mode = state.mode();
        if (mode != null
                && drone.isCommandedFromHere()
                && state.link().state() != LinkState.LOST
                && FlightFacts.isFlying(state)) {
            drone.control().flies(mode);
        }
    }

    private void bringHome(DroneState state, OptionalDouble secondsLeft) {
        ControlState control = drone.control().control();
        LapsedLease lapse = control.lapse();
        if (links.returns() && control.tenure() == null && state.link().state() != LinkState.LOST) {
            returning.update(state, LinkWatch.user(control), secondsLeft);
        } else if (control.tenure() != null
                || links.tries()
                || lapse == null
                || !lapse.returned()
                || !drone.isCommandedFromHere()
                || !FlightFacts.isFlying(state)
                || FlightFacts.isInMission(state)) {
            returning.rest(state);
        } else if (state.link().state() != LinkState.LOST) {
            returning.update(state, lapse.user(), secondsLeft);
        }
    }

    /** Control that came with a command stays in the air with whoever still looks. */
    private boolean isWatched(DroneState state) {
        Lease tenure = drone.control().control().tenure();
        return tenure != null
                && tenure.holder() instanceof LeaseHolder.Person person
                && FlightFacts.isFlying(state)
                && onlookers.isThere(person.name(), drone.id());
    }
}
