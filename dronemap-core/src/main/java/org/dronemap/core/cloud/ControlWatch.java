package org.dronemap.core.cloud;

import java.time.Clock;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.RejectedExecutionException;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.lease.Control;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.lease.Holder;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.lease.LeaseRules;
import org.dronemap.core.lease.Tenure;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Sees to it that control of one drone has its effects: old commands stop, a lost holder's drone is brought to safety, a
 * pilot at the vehicle goes before everybody. Owned by the drone's lane.
 */
final class ControlWatch implements Lane.Ticker {
    private static final Logger LOG = LoggerFactory.getLogger(ControlWatch.class);
    /** A fail-safe says why it changes the mode about when it does. */
    private static final Duration SAID_WITH = Duration.ofSeconds(5);

    private final ManagedDrone drone;
    private final CommandGate gate;
    private final LeaseRules rules;
    private final Presence onlookers;
    private final CloudListener listener;
    private final Clock clock;
    private @Nullable String lastMode;

    ControlWatch(
            ManagedDrone drone,
            CommandGate gate,
            LeaseRules rules,
            Presence onlookers,
            CloudListener listener,
            Clock clock) {
        this.onlookers = onlookers;
        this.drone = drone;
        this.gate = gate;
        this.rules = rules;
        this.listener = listener;
        this.clock = clock;
        drone.control().announceTo(this::announce);
    }

    /** Any thread; in order. */
    private void announce(Control now, List<ControlChange> changes) {
        try {
            drone.lane().execute(() -> changed(now, changes));
        } catch (RejectedExecutionException e) {
            LOG.error("The lane of {} had no room to hear that {}", drone.id(), changes, e);
        }
    }

    private void changed(Control now, List<ControlChange> changes) {
        gate.stopOutdated(drone);
        drone.helm().controlChanged();
        for (ControlChange change : changes) {
            listener.controlChanged(drone.id(), now, change);
            String sentence = ControlWords.of(change);
            boolean concerns = change.kind() != ControlChange.Kind.RETURN_DUE || isLeftAlone();
            if (sentence != null && concerns) {
                drone.say(
                        change.kind() == ControlChange.Kind.LOST ? Severity.WARNING : Severity.NOTICE,
                        sentence,
                        ControlWords.user(change));
            }
            tellOfTheWayHome(change);
            act(change.kind());
        }
        drone.news();
    }

    private void tellOfTheWayHome(ControlChange change) {
        boolean over = change.kind() == ControlChange.Kind.EXPIRED || change.kind() == ControlChange.Kind.RELEASED;
        if (over && rules.onLoss() == LeaseRules.OnLoss.RETURN && isLeftAlone()) {
            drone.say(
                    Severity.WARNING,
                    "Nobody has control of it now: it returns in "
                            + rules.untilReturn().toSeconds() + " s unless somebody takes control.");
        }
    }

    private void act(ControlChange.Kind kind) {
        if (!isLeftAlone()) {
            return;
        }
        boolean lost = switch (kind) {
            case LOST, EXPELLED -> true;
            // What was told where to go goes there; what was led by hand does not stand by itself.
            case EXPIRED, RELEASED -> isLedByHand();
            case TAKEN, REQUESTED, REFUSED, HANDED_OVER, TAKEN_OVER, RETURN_DUE, PILOT_ACTED, PILOT_LEFT -> false;
        };
        if (lost && rules.onLoss() != LeaseRules.OnLoss.NOTHING) {
            gate.submitForSafety(drone, new Command.Hold());
        } else if (kind == ControlChange.Kind.RETURN_DUE) {
            gate.submitForSafety(drone, new Command.ReturnToLaunch());
        }
    }

    private boolean isLedByHand() {
        DroneState state = drone.drone().state();
        return state.capabilities().steering(state.mode()).equals(Optional.of(Steering.STICKS));
    }

    /** In the air and waiting for somebody: what flies by itself goes on, until its mission is over. */
    private boolean isLeftAlone() {
        DroneState state = drone.drone().state();
        return isFlying(state) && waitsForSomebody(state);
    }

    private static boolean isFlying(DroneState state) {
        return Boolean.TRUE.equals(state.armed()) && state.airborne();
    }

    private static boolean waitsForSomebody(DroneState state) {
        return state.capabilities()
                .steering(state.mode())
                .filter(by -> by.waitsForSomebody()
                        || (by == Steering.MISSION && state.mission().complete()))
                .isPresent();
    }

    /** Stops what does not stand by itself when nobody steers it any more, unless somebody else flies it already. */
    static void brake(CommandGate gate, ManagedDrone drone, @Nullable Long epoch) {
        DroneState state = drone.drone().state();
        Optional<Steering> by = state.capabilities().steering(state.mode());
        boolean goesOn = by.isEmpty() || by.get() == Steering.STICKS;
        if (goesOn && CommandRules.canHold(state) && gate.manoeuvre(drone).isEmpty()) {
            gate.submitForSafety(drone, new Command.Hold(), epoch);
        }
    }

    @Override
    public void tick() {
        DroneState state = drone.drone().state();
        boolean fliesByItself = isFlying(state) && !waitsForSomebody(state);
        drone.control().tick(() -> gate.isBusy(drone) || isWatched(state), hasSaidWhatItDoes(state) && !fliesByItself);
        String mode = state.link().state() == LinkState.LIVE ? state.mode() : null;
        Control control = drone.control().control();
        if (control.tenure() != null && control.tenure().holder() instanceof Holder.Pilot) {
            if (Boolean.FALSE.equals(state.armed())) {
                drone.control().apply(new LeaseEvent.PilotLeft());
            }
        } else if (lastMode != null && mode != null && !mode.equals(lastMode) && isPilots(state)) {
            drone.control().apply(new LeaseEvent.PilotActed(mode));
        }
        lastMode = mode;
    }

    /** Control that came with a command stays in the air with whoever still looks. */
    private boolean isWatched(DroneState state) {
        Tenure tenure = drone.control().control().tenure();
        return tenure != null
                && tenure.holder() instanceof Holder.Person person
                && isFlying(state)
                && onlookers.isThere(person.name(), drone.id());
    }

    /**
     * Whether {@link #isLeftAlone} can be told. One that fell silent since is not waited for: what is known of it would be old
     * when it is heard again, and a pilot may have it by then.
     */
    private static boolean hasSaidWhatItDoes(DroneState state) {
        return state.mode() != null && state.armed() != null && (state.phase() != null || state.position() != null);
    }

    /** A mode for sticks that nobody here asked for, and no fail-safe explains. */
    private boolean isPilots(DroneState state) {
        return Boolean.TRUE.equals(state.armed())
                && state.capabilities().steering(state.mode()).equals(Optional.of(Steering.STICKS))
                && !gate.mayHaveChangedMode(drone)
                && state.messages().stream()
                        .filter(message -> message.at().isAfter(clock.instant().minus(SAID_WITH)))
                        .noneMatch(message ->
                                message.text().toLowerCase(Locale.ROOT).contains("failsafe"));
    }
}
