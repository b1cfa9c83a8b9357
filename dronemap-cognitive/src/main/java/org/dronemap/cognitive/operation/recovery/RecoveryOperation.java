package org.dronemap.cognitive.operation.recovery;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronemap.cognitive.operation.recovery.RecoveryInput.Look;
import org.dronemap.cognitive.operation.recovery.RecoveryInput.Observed;
import org.dronemap.cognitive.operation.recovery.RecoveryLeg.HeightSetting;
import org.dronemap.cognitive.operation.recovery.RecoveryLeg.IssuedCommand;
import org.dronemap.cognitive.operation.recovery.RecoveryLeg.IssuedCommand.Purpose;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.Home;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.operation.Objection;
import org.dronemap.core.operation.Operation;
import org.dronemap.core.operation.OperationAction;
import org.dronemap.core.operation.OperationDecision;
import org.dronemap.core.operation.OperationObservation;
import org.dronemap.core.separation.FlightIntent;
import org.jspecify.annotations.Nullable;

/**
 * The state machine of a recovery: several drones stop, and come home or down, each at its height and in its turn, as planned
 * from where they stand.
 */
public final class RecoveryOperation implements Operation<RecoveryState, RecoveryInput> {
    private static final Duration RHYTHM = Duration.ofMillis(200);
    /** Who does not stand by then returns without a place in the plan. */
    private static final Duration LONGEST_STOP = Duration.ofSeconds(20);

    @Override
    public Duration rhythm() {
        return RHYTHM;
    }

    @Override
    public Set<DroneId> drones(RecoveryState state) {
        Set<DroneId> drones = new LinkedHashSet<>();
        state.legs().stream().filter(leg -> !leg.isOver()).forEach(leg -> drones.add(leg.drone()));
        return drones;
    }

    @Override
    public Map<DroneId, FlightIntent> intents(RecoveryState state, Instant now) {
        Map<DroneId, FlightIntent> intents = new HashMap<>();
        state.legs().stream()
                .filter(leg -> !leg.isOver() && leg.step() != RecoveryStep.DOWN)
                .forEach(leg -> intents.put(leg.drone(), LegIntents.of(state, leg)));
        return intents;
    }

    @Override
    public boolean isOver(RecoveryState state) {
        return state.isOver();
    }

    @Override
    public RecoveryInput observed(RecoveryState state, OperationObservation scene) {
        return new Observed(
                scene.now(),
                state.legs().stream()
                        .filter(leg -> !leg.isOver())
                        .flatMap(leg -> scene.of(leg.drone()).map(RecoveryLooks::of).stream())
                        .toList());
    }

    @Override
    public RecoveryInput ended(DroneId drone, CommandId command, Outcome outcome, Instant at) {
        return new RecoveryInput.CommandEnded(at, drone, command, outcome);
    }

    @Override
    public RecoveryInput resumed(Instant at) {
        return new RecoveryInput.Restarted(at);
    }

    @Override
    public OperationDecision<RecoveryState, RecoveryInput> decide(RecoveryState state, RecoveryInput input) {
        if (state.isOver() || refusal(state, input).isPresent()) {
            return OperationDecision.unchanged(state);
        }
        List<OperationAction<RecoveryInput>> actions = new ArrayList<>();
        RecoveryState next;
        if (input instanceof Observed seen) {
            next = observe(state, seen, actions);
        } else if (input instanceof RecoveryInput.CommandEnded ended) {
            next = ended(state, ended);
        } else if (input instanceof RecoveryInput.Cancel cancel) {
            String words = cancel.by() + " called it off.";
            next = state.to(RecoveryStage.GIVING_BACK, cancel.at())
                    .noticed(cancel.at(), words)
                    .ended(words);
        } else {
            next = restarted(state);
        }
        RecoveryState told = withNotices(state, next, input.at());
        return new OperationDecision<>(told, actions, news(state, told));
    }

    private static @Nullable String news(RecoveryState before, RecoveryState next) {
        List<RecoveryState.Notice> notices = next.notices();
        return notices.equals(before.notices())
                ? null
                : notices.get(notices.size() - 1).words();
    }

    private static RecoveryState withNotices(RecoveryState before, RecoveryState next, Instant at) {
        RecoveryState told = next;
        for (RecoveryLeg leg : next.legs()) {
            RecoveryLeg former = before.leg(leg.drone()).orElse(leg);
            String note = leg.signs().note();
            RecoveryLeg.LegEnd end = leg.end();
            if (end != null && former.end() == null) {
                told = told.noticed(at, end.why() == null ? words(leg, end.outcome()) : end.why());
            } else if (note != null && !note.equals(former.signs().note())) {
                told = told.noticed(at, note);
            }
        }
        return told;
    }

    private static String words(RecoveryLeg leg, RecoveryOutcome outcome) {
        return switch (outcome) {
            case DOWN -> leg.name() + " is down.";
            case GIVEN_BACK -> leg.name() + " holds, and is yours.";
            case NOT_KNOWN, TAKEN, FAILED -> leg.name() + " is no longer in the recovery.";
        };
    }

    private static RecoveryState observe(
            RecoveryState state, Observed seen, List<OperationAction<RecoveryInput>> actions) {
        RecoveryState next = state;
        boolean allStand = true;
        for (RecoveryLeg leg : state.legs()) {
            Look look = seen.of(leg.drone()).orElse(null);
            if (leg.isOver()) {
                continue;
            }
            if (look == null) {
                next = next.with(leg.ended(RecoveryOutcome.FAILED, leg.name() + " was removed."));
                continue;
            }
            LegFlight flight = new LegFlight(next, leg, look, seen.at());
            allStand &= look.isSilent() || flight.isStanding() || !look.flight().airborne();
            next = next.with(heightNoted(flight.next(), look));
            actions.addAll(flight.actions());
        }
        boolean late = Duration.between(state.since(), seen.at()).compareTo(LONGEST_STOP) > 0;
        if (state.stage() == RecoveryStage.STOPPING && (allStand || late)) {
            next = planned(next, seen);
        }
        return over(next, seen.at());
    }

    /** What was set before shows once its own height was set. */
    private static RecoveryLeg heightNoted(RecoveryLeg leg, Look look) {
        RecoverySlot slot = leg.slot();
        Double set = look.place().returnMeters();
        Double before = look.place().returnBeforeMeters();
        boolean shows = slot != null
                && leg.height().asked()
                && leg.height().beforeMeters() == null
                && leg.step() != RecoveryStep.DOWN
                && set != null
                && before != null
                && Math.abs(set - slot.layerMeters()) <= 1
                && Math.abs(set - before) > 0.5;
        return shows ? leg.with(new HeightSetting(true, before)) : leg;
    }

    /** From where they stand now. */
    private static RecoveryState planned(RecoveryState state, Observed seen) {
        List<RecoveryDrone> standing = new ArrayList<>();
        for (RecoveryLeg leg : state.legs()) {
            seen.of(leg.drone())
                    .filter(look -> !leg.isOver() && new LegFlight(state, leg, look, seen.at()).isStanding())
                    .flatMap(look -> drone(leg, look))
                    .ifPresent(standing::add);
        }
        RecoveryState next = state.to(RecoveryStage.COMING_DOWN, seen.at());
        if (standing.isEmpty()) {
            return next;
        }
        RecoveryPlan plan = RecoveryPlanner.plan(state.order(), standing);
        if (plan.why() != null) {
            return state.to(RecoveryStage.GIVING_BACK, seen.at())
                    .noticed(seen.at(), plan.why())
                    .ended(plan.why());
        }
        for (RecoverySlot slot : plan.slots()) {
            RecoveryLeg leg = next.leg(slot.drone()).orElseThrow();
            boolean straight = state.order().manner() == RecoveryManner.LAND
                    || standing.stream()
                            .anyMatch(
                                    one -> one.drone().equals(slot.drone()) && one.isStraightDown(slot.layerMeters()));
            next = next.with(leg.planned(slot, straight ? RecoveryStep.OVER_HOME : RecoveryStep.ALOFT));
        }
        return next.noticed(seen.at(), "All stand; " + plan.slots().size() + " come down one after the other.");
    }

    private static Optional<RecoveryDrone> drone(RecoveryLeg leg, Look look) {
        Geodetic point = look.place().point();
        Double height = look.place().heightMeters();
        Geodetic home = look.place().home();
        Double ground = look.place().homeAmslMeters();
        return point == null || height == null || home == null || ground == null
                ? Optional.empty()
                : Optional.of(new RecoveryDrone(
                        leg.drone(), leg.name(), point, height, new Home(home, ground), leg.highestMeters()));
    }

    private static RecoveryState over(RecoveryState state, Instant at) {
        if (!state.legs().stream().allMatch(RecoveryLeg::isOver)) {
            return state;
        }
        long down = state.legs().stream()
                .filter(leg -> leg.end() != null && leg.end().outcome() == RecoveryOutcome.DOWN)
                .count();
        String words = down == state.legs().size()
                ? "All are down."
                : down + " of " + state.legs().size() + " are down.";
        return state.to(RecoveryStage.OVER, at).ended(state.end() == null ? words : state.end() + " " + words);
    }

    private static RecoveryState ended(RecoveryState state, RecoveryInput.CommandEnded ended) {
        RecoveryLeg leg = state.leg(ended.drone()).orElse(null);
        IssuedCommand issued = leg == null ? null : leg.issued();
        return leg == null || issued == null || !issued.command().equals(ended.command())
                ? state
                : state.with(LegCommands.ended(leg, issued, ended));
    }

    /** What was sent once is sent again, since it may have been lost. */
    private static RecoveryState restarted(RecoveryState state) {
        return state.with(state.legs().stream()
                .map(leg -> leg.sent() == Purpose.GO_TO && leg.issued() == null ? leg.sent(null) : leg)
                .toList());
    }

    @Override
    public String words(RecoveryState state) {
        return "The recovery " + state.id();
    }

    @Override
    public Optional<Objection> refusal(RecoveryState state, RecoveryInput input) {
        return input instanceof RecoveryInput.Cancel && state.stage() == RecoveryStage.GIVING_BACK
                ? Optional.of(Objection.of(
                        RecoveryObjection.GIVING_BACK,
                        "It was called off already; its drones hold, and control goes over."))
                : Optional.empty();
    }
}
