package org.dronemap.core.cloud;

import java.util.EnumSet;
import java.util.Set;
import org.dronemap.core.cloud.rule.CommandRules;
import org.dronemap.core.cloud.rule.FlightFacts;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.EmergencyStop;
import org.dronemap.core.command.GoToLocal;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.lease.ControlChange;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.core.lease.LeaseRules;
import org.jspecify.annotations.Nullable;

/**
 * Makes one drone hold its position when its user's control has ended and it would go on moving. Owned by the drone's
 * lane.
 */
final class HoldOnControlLoss {
    private static final double STANDS_METERS_PER_SECOND = 0.1;
    private static final Set<ControlChange.Kind> ENDS = EnumSet.of(
            ControlChange.Kind.LOST,
            ControlChange.Kind.EXPELLED,
            ControlChange.Kind.EXPIRED,
            ControlChange.Kind.RELEASED);

    private final ManagedDrone drone;
    private final CommandGate gate;
    private final LeaseRules rules;
    /** The last that came while it was not known what the drone does. */
    private @Nullable ControlChange missed;

    HoldOnControlLoss(ManagedDrone drone, CommandGate gate, LeaseRules rules) {
        this.drone = drone;
        this.gate = gate;
        this.rules = rules;
    }

    void act(ControlChange change) {
        boolean ends = ENDS.contains(change.kind()) && change.by() instanceof LeaseHolder.Person;
        if (!ends || rules.onLoss() == LeaseRules.OnLoss.NOTHING) {
            return;
        }
        if (drone.isStateUnknown()) {
            missed = change;
        } else if (drone.isCommandedFromHere()) {
            hold(change);
        }
    }

    /** Once it is known again what the drone does. */
    void actOnMissed() {
        ControlChange late = missed;
        missed = null;
        if (late != null && drone.control().control().tenure() == null) {
            act(late);
        }
    }

    private void hold(ControlChange change) {
        DroneState state = drone.drone().state();
        boolean lost = change.kind() == ControlChange.Kind.LOST || change.kind() == ControlChange.Kind.EXPELLED;
        if (!CommandRules.needsAir(state)) {
            if (!FlightFacts.isInMission(state)) {
                stop(state);
            }
        } else if (drone.isUncontrolledInAir() && (lost || FlightFacts.isSteeredManually(state))) {
            // One that was told where to go goes there; one that was led by hand does not stand by itself.
            gate.submitForSafety(drone, new Command.Hold());
        }
    }

    /** A ground vehicle that is on its way somewhere. Robots let nothing end that but an emergency stop. */
    private void stop(DroneState state) {
        boolean goes = drone.recentModeCommands().at(drone.lane().activeNanos()).stream()
                        .anyMatch(GoToLocal.class::isInstance)
                || gate.manoeuvre(drone).isPresent();
        Motion motion = state.motion();
        Double speed = motion == null ? null : motion.groundSpeed();
        if (!goes && (speed == null || speed < STANDS_METERS_PER_SECOND)) {
            return;
        }
        if (goes && CommandRules.whyNot(state, Capability.EMERGENCY_STOP).isEmpty()) {
            gate.submitForSafety(drone, new EmergencyStop());
        } else if (CommandRules.canHold(state)) {
            gate.submitForSafety(drone, new Command.Hold());
        }
    }
}
