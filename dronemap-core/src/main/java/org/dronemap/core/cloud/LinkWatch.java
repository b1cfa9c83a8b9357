package org.dronemap.core.cloud;

import java.time.Clock;
import org.dronemap.core.cloud.rule.CommandTracker;
import org.dronemap.core.cloud.rule.FlightFacts;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.lease.ControlState;
import org.dronemap.core.lease.LapsedLease;
import org.dronemap.core.lease.Lease;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.core.lease.LeaseRules;
import org.dronemap.core.safety.LinkAct;
import org.dronemap.core.safety.LinkLossAvoidance;
import org.dronemap.core.safety.LinkLossAvoidance.Holder;
import org.dronemap.core.time.Time;
import org.dronemap.core.zone.RouteObjection;
import org.dronemap.core.zone.ZoneRules;
import org.jspecify.annotations.Nullable;

/**
 * Acts on one flying drone before its link is lost: warns who has it in hand, and has one that nobody has climb, slow down
 * or come home. Owned by the drone's lane.
 */
final class LinkWatch {
    private final ManagedDrone drone;
    private final CommandGate gate;
    private final ZoneRules zones;
    private final LeaseRules rules;
    private final Time time;
    private final Clock clock;
    private final LinkLossAvoidance avoidance = new LinkLossAvoidance();
    private @Nullable CommandTracker command;
    private @Nullable LinkAct retried;

    LinkWatch(ManagedDrone drone, CommandGate gate, ZoneRules zones, LeaseRules rules, Time time) {
        this.drone = drone;
        this.gate = gate;
        this.zones = zones;
        this.rules = rules;
        this.time = time;
        this.clock = time.clock();
    }

    /** True as long as it is to be brought home for its link. */
    boolean returns() {
        return avoidance.returns();
    }

    /** True as long as it is to be seen whether what it was told helps: nobody brings it home meanwhile. */
    boolean tries() {
        return avoidance.tries();
    }

    /** On whose account it flies: what binds that user binds the ways that are chosen here. */
    static String user(ControlState control) {
        LapsedLease lapse = control.lapse();
        return lapse == null ? "" : lapse.user();
    }

    void update(DroneState state) {
        boolean safe = state.capabilities().isSafe(state.mode()) && !avoidance.returns();
        if (!FlightFacts.isFlying(state) || safe) {
            avoidance.rest();
            retried = null;
            return;
        }
        if (state.link().state() == LinkState.LOST) {
            return;
        }
        resend();
        ControlState control = drone.control().control();
        avoidance
                .next(
                        state,
                        holder(control),
                        FlightFacts.isInMission(state),
                        time.nanos() / 1e9,
                        way -> zones.whyNot(user(control), state, way, clock.instant())
                                .map(RouteObjection::sentence))
                .ifPresent(this::act);
    }

    private Holder holder(ControlState control) {
        Lease tenure = control.tenure();
        if (tenure == null) {
            // Where nobody's drones are not brought home, nothing is done with them for this either.
            boolean brought = drone.isCommandedFromHere() && rules.onLoss() == LeaseRules.OnLoss.RETURN;
            return brought ? Holder.NOBODY : Holder.OTHERS;
        }
        if (tenure.holder() instanceof LeaseHolder.Person) {
            return Holder.USER;
        }
        return tenure.holder() instanceof LeaseHolder.Operation ? Holder.OPERATION : Holder.OTHERS;
    }

    private void act(LinkAct act) {
        drone.publishMessage(act.kind() == LinkAct.Kind.GO_ON ? Severity.NOTICE : Severity.WARNING, act.reason());
        retried = null;
        if (act.command() != null) {
            send(act);
            retried = act;
        }
    }

    private void send(LinkAct act) {
        if (act.command() != null) {
            command = gate.submitForSafety(drone, act.command()).orElse(null);
        }
    }

    /** Once more: messages get lost on such a link. */
    private void resend() {
        CommandTracker told = command;
        LinkAct act = retried;
        Outcome outcome = told == null ? null : told.record().outcome();
        if (act != null && outcome != null) {
            retried = null;
            if (!(outcome instanceof Outcome.Succeeded)) {
                send(act);
            }
        }
    }
}
