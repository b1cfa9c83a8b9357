package org.dronemap.cognitive.operation.dispatch;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.dronemap.cognitive.operation.dispatch.DispatchInput.Look;
import org.dronemap.cognitive.operation.dispatch.DispatchInput.Observed;
import org.dronemap.cognitive.operation.dispatch.DispatchLeg.IssuedCommand;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.operation.Objection;
import org.dronemap.core.operation.Operation;
import org.dronemap.core.operation.OperationAction;
import org.dronemap.core.operation.OperationDecision;
import org.dronemap.core.operation.OperationObservation;
import org.dronemap.core.separation.FlightIntent;
import org.jspecify.annotations.Nullable;

/**
 * The state machine of a dispatch: a drone of the pool starts, flies to a place, and its control goes over to whoever
 * asked. One that cannot come flies home, and another one comes in its place.
 */
public final class DispatchOperation implements Operation<DispatchState, DispatchInput> {
    private static final Duration RHYTHM = Duration.ofMillis(200);
    /** So long another drone is looked for, at most. */
    private static final Duration LONGEST_SEARCH = Duration.ofSeconds(60);

    /** Whoever asked so long ago does not expect motors to start now. */
    private static final Duration LATE = Duration.ofSeconds(60);

    @Override
    public Duration rhythm() {
        return RHYTHM;
    }

    @Override
    public Set<DroneId> drones(DispatchState state) {
        return drones(state, state.stage().leads());
    }

    @Override
    public Set<DroneId> watched(DispatchState state) {
        return drones(state, true);
    }

    private static Set<DroneId> drones(DispatchState state, boolean withLead) {
        Set<DroneId> drones = new LinkedHashSet<>();
        if (withLead && state.lead() != null) {
            drones.add(state.lead().drone());
        }
        state.returning().forEach(leg -> drones.add(leg.drone()));
        return drones;
    }

    @Override
    public Map<DroneId, FlightIntent> intents(DispatchState state, Instant now) {
        return DispatchIntents.of(state);
    }

    @Override
    public boolean isOver(DispatchState state) {
        return state.isOver();
    }

    @Override
    public DispatchInput observed(DispatchState state, OperationObservation scene) {
        List<Look> looks = legs(state)
                .flatMap(leg -> scene.of(leg.drone()).map(seen -> DispatchLooks.of(state, leg, seen)).stream())
                .toList();
        return new Observed(scene.now(), looks);
    }

    private static Stream<DispatchLeg> legs(DispatchState state) {
        return Stream.concat(Stream.ofNullable(state.lead()), state.returning().stream());
    }

    @Override
    public DispatchInput ended(DroneId drone, CommandId command, Outcome outcome, Instant at) {
        return new DispatchInput.CommandEnded(at, drone, command, outcome);
    }

    @Override
    public DispatchInput resumed(Instant at) {
        return new DispatchInput.Restarted(at);
    }

    @Override
    public OperationDecision<DispatchState, DispatchInput> decide(DispatchState state, DispatchInput input) {
        if (state.isOver() || refusal(state, input).isPresent()) {
            return OperationDecision.unchanged(state);
        }
        List<OperationAction<DispatchInput>> actions = new ArrayList<>();
        DispatchState next;
        if (input instanceof Observed seen) {
            next = observe(state, seen, actions);
        } else if (input instanceof DispatchInput.CommandEnded ended) {
            next = ended(state, ended);
        } else if (input instanceof DispatchInput.Restarted) {
            next = restarted(state, input.at());
        } else if (input instanceof DispatchInput.SendDrone send) {
            next = state.withLead(DispatchLeg.of(send.chosen(), state.failed().size()))
                    .to(DispatchStage.CHOSEN, send.at(), send.chosen().why());
        } else if (input instanceof DispatchInput.NoDroneAvailable none) {
            next = state.end(none.at(), "No other drone can come. " + none.why());
        } else {
            next = state.withLeadReturning().end(input.at(), calledOff(input));
        }
        return new OperationDecision<>(next, actions, news(state, next));
    }

    private static String calledOff(DispatchInput input) {
        return input instanceof DispatchInput.Cancel cancel ? cancel.by() + " called it off." : "It was called off.";
    }

    private static @Nullable String news(DispatchState before, DispatchState next) {
        List<DispatchState.Notice> notices = next.log().notices();
        return notices.equals(before.log().notices())
                ? null
                : notices.get(notices.size() - 1).words();
    }

    private static DispatchState observe(
            DispatchState state, Observed seen, List<OperationAction<DispatchInput>> actions) {
        DispatchLeg lead = state.lead();
        DispatchState next = state;
        if (lead != null) {
            next = seen.of(lead.drone())
                    .map(look -> new LeadFlight(state, lead, look, seen.at(), actions).next())
                    .orElseGet(() -> removed(state, lead, seen.at()));
        } else if (state.isSearching()
                && Duration.between(state.since(), seen.at()).compareTo(LONGEST_SEARCH) > 0) {
            next = state.end(seen.at(), "No other drone was found within " + LONGEST_SEARCH.toSeconds() + " s.");
        }
        // Who begins to fly home only now is told so at the next look.
        return next.returning().equals(state.returning()) ? ReturningLegs.next(next, seen, actions) : next;
    }

    private static DispatchState removed(DispatchState state, DispatchLeg lead, Instant at) {
        String words = lead.name() + " was removed.";
        return state.stage().leads()
                ? state.withLead(null).failing(lead.drone()).to(DispatchStage.SEARCHING, at, words)
                : state.end(at, words);
    }

    private static DispatchState ended(DispatchState state, DispatchInput.CommandEnded ended) {
        DispatchLeg lead = state.lead();
        if (lead != null && isOf(lead, ended)) {
            LegOutcome outcome = outcome(lead, ended);
            DispatchState next = state.withLead(outcome.leg());
            return outcome.notice() == null ? next : next.withNotice(ended.at(), outcome.notice());
        }
        return state.withReturning(state.returning().stream()
                .map(leg -> isOf(leg, ended) ? outcome(leg, ended).leg() : leg)
                .toList());
    }

    private static boolean isOf(DispatchLeg leg, DispatchInput.CommandEnded ended) {
        IssuedCommand issued = leg.issued();
        return issued != null && issued.command().equals(ended.command());
    }

    private static LegOutcome outcome(DispatchLeg leg, DispatchInput.CommandEnded ended) {
        IssuedCommand issued = leg.issued();
        return issued == null ? new LegOutcome(leg, null) : LegOutcome.of(leg, issued, ended);
    }

    /** What was told once is told again, since it may have been lost. */
    private static DispatchState restarted(DispatchState state, Instant at) {
        DispatchLeg lead = state.lead();
        boolean starts = state.stage() == DispatchStage.CHOSEN || state.stage() == DispatchStage.STARTING;
        if (lead != null && starts && Duration.between(state.since(), at).compareTo(LATE) > 0) {
            return state.withLeadReturning()
                    .end(
                            at,
                            "The server was stopped while " + lead.name()
                                    + " took off, and came back too late; it flies home.");
        }
        return lead != null && state.stage() == DispatchStage.EN_ROUTE && lead.issued() == null
                ? state.withLead(lead.anew()).restarted(at)
                : state.restarted(at);
    }

    @Override
    public String words(DispatchState state) {
        return "The dispatch " + state.id();
    }

    @Override
    public Optional<Objection> refusal(DispatchState state, DispatchInput input) {
        if (input instanceof DispatchInput.SendDrone send) {
            return state.isSearching() && !state.failed().contains(send.chosen().drone())
                    ? Optional.empty()
                    : notSearching();
        }
        if (input instanceof DispatchInput.NoDroneAvailable) {
            return state.isSearching() ? Optional.empty() : notSearching();
        }
        return input instanceof DispatchInput.Cancel && state.stage() == DispatchStage.RETURNING
                ? Optional.of(Objection.of(
                        DispatchObjection.RETURNING, "It was called off already; what flew for it is on its way home."))
                : Optional.empty();
    }

    private static Optional<Objection> notSearching() {
        return Optional.of(Objection.of(DispatchObjection.NOT_SEARCHING, "No other drone has to come now."));
    }
}
