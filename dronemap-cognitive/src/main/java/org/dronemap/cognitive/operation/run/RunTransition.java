package org.dronemap.cognitive.operation.run;

import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.dronemap.cognitive.operation.run.model.PendingReplan;
import org.dronemap.cognitive.operation.run.model.ReplanCause;
import org.dronemap.cognitive.operation.run.model.ReplanProposal;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunExplanation;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunSettings;
import org.dronemap.cognitive.operation.run.model.RunTrigger;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.operation.run.model.Sortie;
import org.dronemap.cognitive.problem.Task;
import org.dronemap.cognitive.replan.ReplanResult;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.operation.OperationAction;
import org.dronemap.core.operation.OperationDecision;
import org.jspecify.annotations.Nullable;

/**
 * A decision of a mission run in the making: the next state, and the actions to carry out. Made for one decision, owned
 * by its thread.
 */
final class RunTransition {
    private final RunState before;
    private final Instant now;
    private final Map<String, RunWaypoint> targets = new LinkedHashMap<>();
    private final Map<DroneId, RunDrone> drones = new LinkedHashMap<>();
    private final List<ReplanCause> causes;
    private final List<RunExplanation> explanations;
    private final List<OperationAction<RunInput>> actions = new ArrayList<>();
    private final List<String> texts = new ArrayList<>();
    private RunCounters tally;
    private RunSettings setting;
    private RunState.Clock clock;
    private @Nullable PendingReplan request;
    private @Nullable ReplanProposal proposal;
    private boolean stopping;
    private @Nullable String end;

    RunTransition(RunState state, Instant now) {
        this.before = state;
        this.now = now;
        state.targets().forEach(target -> targets.put(target.id(), target));
        state.drones().forEach(drone -> drones.put(drone.id(), drone));
        causes = new ArrayList<>(state.causes());
        explanations = new ArrayList<>(state.explanations());
        tally = new RunCounters(state.counts());
        setting = state.setting();
        clock = state.clock();
        request = state.request();
        proposal = state.proposal();
        stopping = state.stopping();
        end = state.end();
    }

    Instant now() {
        return now;
    }

    boolean isWordedBefore(int number) {
        return before.isWordedBefore(number);
    }

    RunCounters tally() {
        return tally;
    }

    RunSettings setting() {
        return setting;
    }

    void setting(RunSettings other) {
        setting = other;
    }

    RunState.Clock clock() {
        return clock;
    }

    void clock(RunState.Clock other) {
        clock = other;
    }

    @Nullable
    PendingReplan request() {
        return request;
    }

    void request(@Nullable PendingReplan other) {
        request = other;
    }

    @Nullable
    ReplanProposal proposal() {
        return proposal;
    }

    void proposal(@Nullable ReplanProposal other) {
        proposal = other;
    }

    List<ReplanCause> causes() {
        return causes;
    }

    boolean plansNothing() {
        return stopping || isPaused();
    }

    boolean isPaused() {
        return clock.pausedSince() != null;
    }

    boolean stopping() {
        return stopping;
    }

    void stopRun() {
        stopping = true;
    }

    void end(String words) {
        end = words;
    }

    List<RunDrone> drones() {
        return List.copyOf(drones.values());
    }

    RunDrone drone(DroneId id) {
        return Objects.requireNonNull(drones.get(id), () -> "no drone " + id);
    }

    boolean knows(DroneId id) {
        return drones.containsKey(id);
    }

    public void put(RunDrone drone) {
        drones.put(drone.id(), drone);
    }

    List<RunWaypoint> targets() {
        return List.copyOf(targets.values());
    }

    RunWaypoint target(String id) {
        return Objects.requireNonNull(targets.get(id), () -> "no waypoint " + id);
    }

    Task task(String waypoint) {
        return target(waypoint).waypoint().task();
    }

    public void put(RunWaypoint target) {
        targets.put(target.id(), target);
    }

    /** A command to that drone, whose errand it is from now on. */
    void sendCommand(RunDrone drone, RunDrone.IssuedCommand.Purpose kind, Command command) {
        CommandId id = new CommandId(before.id().value() + String.format("-c%05d", tally.command()));
        Sortie brought = kind == RunDrone.IssuedCommand.Purpose.UPLOAD ? drone.next() : null;
        put(drone.withIssuedCommand(new RunDrone.IssuedCommand(id, kind, brought == null ? 0 : brought.number(), now)));
        actions.add(new OperationAction.SendCommand<>(drone.id(), id, command));
    }

    void requestComputation(ReplanComputation what) {
        actions.add(new OperationAction.Compute<>(what));
    }

    /** Something was decided without a plan. */
    void explain(RunTrigger trigger, @Nullable DroneId drone, String words) {
        add(new RunExplanation(tally.explanation(), now, trigger, drone, List.of(), null, null, words));
    }

    /** A plan was decided on. */
    void explain(ReplanCause cause, ReplanResult plan, String words) {
        add(new RunExplanation(
                tally.explanation(),
                now,
                cause.trigger(),
                cause.drone(),
                plan.changes().moved(),
                plan.before(),
                plan.after(),
                words));
    }

    private void add(RunExplanation explanation) {
        explanations.add(explanation);
        if (explanations.size() > RunState.MOST_EXPLANATIONS) {
            explanations.remove(0);
        }
        texts.add(explanation.words());
    }

    /** Something happened that the plan has to be changed for. */
    void addCause(RunTrigger trigger, @Nullable DroneId drone, String words) {
        addCause(trigger, drone, words, List.of());
    }

    /** {@code orphans}: what the drone had to visit until then. */
    void addCause(RunTrigger trigger, @Nullable DroneId drone, String words, List<String> orphans) {
        explain(trigger, drone, words);
        if (!stopping) {
            causes.add(new ReplanCause(trigger, drone, words, orphans));
        }
    }

    /** What was that drone's is nobody's now. */
    RunDrone release(RunDrone drone, String why) {
        for (RunWaypoint target : targets()) {
            if (drone.id().equals(target.drone()) && !target.state().isSettled()) {
                put(target.to(stopping ? RunWaypoint.State.UNSERVED : RunWaypoint.State.WAITING, null, why));
            }
        }
        return drone.withOrders(List.of()).withNext(null);
    }

    OperationDecision<RunState, RunInput> decision() {
        RunState next = new RunState(
                before.id(),
                clock,
                setting,
                targets(),
                drones(),
                tally.counts(),
                request,
                causes,
                proposal,
                explanations,
                stopping,
                end,
                before.wording());
        return next.equals(before) && actions.isEmpty()
                ? OperationDecision.unchanged(before)
                : new OperationDecision<>(next, actions, texts.isEmpty() ? null : String.join(" ", texts));
    }
}
