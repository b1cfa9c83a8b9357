package org.dronemap.core.cloud;

import java.time.Clock;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronemap.core.cloud.outlook.CloudLossMessages;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandKind;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.ParameterOverrideRecorder;
import org.dronemap.core.command.RestoreParameters;
import org.dronemap.core.command.SetCloudLossAction;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.CloudLossState;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.ParameterOverrides;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.parameter.OverriddenParameter;
import org.dronemap.core.safety.ReturnEnding;
import org.jspecify.annotations.Nullable;

/**
 * Before the first arming here, sets a vehicle to return on loss of the cloud; restores the owner's values later. Both
 * only while it stands disarmed. Owned by the drone's lane.
 */
final class CloudLossPreparation implements FlightPreparation {
    /** Longer nobody waits for it who wants to fly. */
    private static final long LONGEST_NANOS = Duration.ofSeconds(7).toNanos();

    private static final long LONGEST_BACK_NANOS = Duration.ofSeconds(30).toNanos();
    /** Who has just landed may go on. */
    private static final long UNUSED_NANOS = Duration.ofSeconds(10).toNanos();

    private static final long BETWEEN_TRIES_NANOS = Duration.ofMinutes(1).toNanos();

    private final ManagedDrone drone;
    private final CommandGate gate;
    private final ParameterOverrideRegistry desk;
    private final Clock clock;
    private final ReturnConflictWatch crossing;
    private @Nullable Task work;
    private boolean prepared;
    private boolean toldOfFailure;
    private @Nullable Long unusedSince;
    private long notBefore;
    private @Nullable ReturnEnding toldEnd;
    private volatile CloudLossState state;

    /** A command of this rule that is under way, and those that wait for its end. */
    private record Task(
            PendingCommand own, CloudLossOverrideRecorder notes, long since, Map<PendingCommand, Runnable> waiting) {}

    CloudLossPreparation(ManagedDrone drone, CommandGate gate, ParameterOverrideRegistry desk, Clock clock) {
        this.drone = drone;
        this.gate = gate;
        this.desk = desk;
        this.clock = clock;
        this.crossing = new ReturnConflictWatch(drone, desk.heights());
        this.notBefore = drone.lane().activeNanos();
        // What was written in an earlier run of the server, for a use that is not over, is not written once more.
        Optional<ParameterOverrides> before = desk.kept(drone.id()).filter(ParameterOverrides::written);
        this.prepared = before.isPresent();
        this.state = before.map(CloudLossMessages::setBefore).orElse(CloudLossState.UNKNOWN);
        drone.drone().returnsAt(state.returnMeters());
    }

    @Override
    public CloudLossState state() {
        Capabilities can = drone.drone().state().capabilities();
        if (can.known() && !can.commands().contains(Capability.SET_PARAMETERS)) {
            return CloudLossMessages.cannotBeSet(CloudLossMessages.CANNOT_BE_SET);
        }
        CloudLossState now = state;
        return atHome().map(now::and)
                .orElse(now)
                .withOutstanding(desk.kept(drone.id())
                        .map(kept -> kept.values().stream()
                                .filter(OverriddenParameter::isToBeWritten)
                                .toList())
                        .orElse(List.of()));
    }

    private Optional<String> atHome() {
        return CloudLossMessages.atHome(homecoming(), state.action());
    }

    private ReturnEnding homecoming() {
        return ReturnEnding.of(drone.drone().state(), state.action());
    }

    /** Before it flies, and only what is not as everybody expects it. */
    private void announceReturnEnding() {
        ReturnEnding end = homecoming();
        if (end != ReturnEnding.LANDS && end != ReturnEnding.LANDS_BY_MISSION && end != toldEnd) {
            atHome().ifPresent(sentence ->
                    drone.publishMessage(end == ReturnEnding.CIRCLES ? Severity.WARNING : Severity.NOTICE, sentence));
        }
        toldEnd = end;
    }

    @Override
    public boolean delays(PendingCommand entry, Runnable goOn) {
        if (!leadsToFlight(entry.open().command().kind()) || !stands()) {
            return false;
        }
        Task now = work;
        if (now != null && now.own().open().command() instanceof RestoreParameters) {
            gate.dispatch().abort(now.own(), replaced(entry));
            now = null;
        }
        if (now != null) {
            now.waiting().put(entry, goOn);
            return true;
        }
        if (prepared || !canBeSet() || isWrittenToByOthers(entry)) {
            announceReturnEnding();
            return false;
        }
        prepare(entry, goOn);
        return true;
    }

    private static boolean leadsToFlight(CommandKind kind) {
        return kind == CommandKind.ARM
                || kind == CommandKind.TAKE_OFF
                || kind == CommandKind.START_MISSION
                || kind == CommandKind.SET_RETURN_HEIGHT
                || kind == CommandKind.RETURN_ON_LOSS;
    }

    /** For certain: what has not said so may be flown by anybody. */
    private boolean stands() {
        DroneState now = drone.drone().state();
        return Boolean.FALSE.equals(now.armed()) && !now.airborne();
    }

    private boolean canBeSet() {
        DroneState now = drone.drone().state();
        if (now.capabilities().commands().contains(Capability.SET_PARAMETERS)) {
            return true;
        }
        state = CloudLossMessages.cannotBeSet(CloudLossMessages.CANNOT_BE_SET);
        return false;
    }

    /** Two who write parameters at once would read back each other's. */
    private boolean isWrittenToByOthers(PendingCommand entry) {
        Optional<String> other = gate.writingParameters(entry);
        other.ifPresent(what -> failed(null, "Wait for the end of what is under way: " + what + "."));
        return other.isPresent();
    }

    private void prepare(PendingCommand entry, Runnable goOn) {
        CloudLossOverrideRecorder notes = notes();
        Command command = new SetCloudLossAction(desk.afterSeconds(), notes.earlier(), notes);
        Map<PendingCommand, Runnable> waiting = new LinkedHashMap<>();
        waiting.put(entry, goOn);
        begin(command, entry.passage(), notes, waiting);
    }

    private CloudLossOverrideRecorder notes() {
        return new CloudLossOverrideRecorder(
                drone.drone().state(),
                desk,
                height -> gate.mayFlyHomeAt(drone.drone().state(), height),
                clock);
    }

    private void begin(
            Command command,
            ControlClearance.Cleared passage,
            CloudLossOverrideRecorder notes,
            Map<PendingCommand, Runnable> waiting) {
        PendingCommand own = gate.begin(drone, command, passage);
        work = new Task(own, notes, drone.lane().activeNanos(), waiting);
        gate.dispatch().performFirst(own);
    }

    @Override
    public void ended(PendingCommand entry, Outcome outcome) {
        Task now = work;
        if (now == null) {
            return;
        }
        if (entry.equals(now.own())) {
            work = null;
            if (entry.open().command() instanceof RestoreParameters) {
                putBack(now, outcome);
            } else {
                set(now, outcome);
                announceReturnEnding();
            }
            drone.news();
            new ArrayList<>(now.waiting().values()).forEach(Runnable::run);
        } else if (now.waiting().remove(entry) != null && now.waiting().isEmpty()) {
            gate.dispatch().abort(now.own(), new Outcome.Superseded("What it was set for is not wanted any more."));
        }
    }

    private void set(Task done, Outcome outcome) {
        ParameterOverrideRecorder.@Nullable OverridePlan plan = done.notes().plan();
        switch (outcome.kind()) {
            case SUCCEEDED -> isSet(plan, done.notes().crossing());
            case REFUSED -> isNotToBeSet(outcome.reason());
            case FAILED, TIMED_OUT, UNKNOWN -> failed(plan, outcome.reason());
            case SUPERSEDED -> {}
        }
        if (desk.kept(drone.id()).isEmpty() && !prepared) {
            desk.heights().release(drone.id());
        }
    }

    private void isSet(ParameterOverrideRecorder.@Nullable OverridePlan plan, boolean crossing) {
        prepared = true;
        desk.kept(drone.id()).ifPresent(kept -> desk.written(kept, true));
        if (plan != null) {
            state = CloudLossMessages.set(plan, crossing);
            if (plan.returnMeters() != null) {
                drone.drone().returnsAt(plan.returnMeters());
            }
            CloudLossMessages.notable(plan, crossing)
                    .ifPresent(sentence -> drone.publishMessage(Severity.NOTICE, sentence));
        }
    }

    @Override
    public void returnsAt(double meters) {
        if (prepared && state.returnMeters() != null) {
            state = state.returningAt(meters);
            desk.returnsAt(drone.id(), meters);
        }
    }

    private void isNotToBeSet(@Nullable String why) {
        prepared = true;
        state = CloudLossMessages.cannotBeSet(why == null ? CloudLossMessages.CANNOT_BE_SET : why);
        drone.publishMessage(Severity.NOTICE, state.sentence());
    }

    private void failed(ParameterOverrideRecorder.@Nullable OverridePlan plan, @Nullable String why) {
        state = CloudLossMessages.notSet(plan, why);
        drone.publishMessage(Severity.WARNING, state.sentence());
    }

    private void putBack(Task done, Outcome outcome) {
        switch (outcome.kind()) {
            case SUCCEEDED -> {
                done.notes().left().forEach(sentence -> drone.publishMessage(Severity.WARNING, sentence));
                over();
            }
            case SUPERSEDED -> {}
            case REFUSED, FAILED, TIMED_OUT, UNKNOWN -> {
                notBefore = drone.lane().activeNanos() + BETWEEN_TRIES_NANOS;
                if (!toldOfFailure) {
                    toldOfFailure = true;
                    drone.publishMessage(Severity.WARNING, CloudLossMessages.notPutBack(outcome.reason()));
                }
            }
        }
    }

    /** The next one who uses it prepares it anew. */
    private void over() {
        prepared = false;
        toldOfFailure = false;
        toldEnd = null;
        unusedSince = null;
        if (state.returnMeters() != null) {
            drone.drone().returnsAt(null);
        }
        state = CloudLossState.UNKNOWN;
        if (desk.kept(drone.id()).isPresent()) {
            desk.done(drone.id());
        } else {
            desk.heights().release(drone.id());
        }
    }

    @Override
    public void advance() {
        crossing.update();
        Task now = work;
        long nanos = drone.lane().activeNanos();
        if (now != null) {
            watch(now, nanos);
        } else if (prepared || desk.kept(drone.id()).isPresent()) {
            awaitEndOfUse(nanos);
        }
    }

    /** Nothing more is written to what somebody else has armed meanwhile. */
    private void watch(Task now, long nanos) {
        boolean back = now.own().open().command() instanceof RestoreParameters;
        long longest = back ? LONGEST_BACK_NANOS : LONGEST_NANOS;
        if (!stands()) {
            gate.dispatch().abort(now.own(), new Outcome.Failed("It was armed meanwhile."));
        } else if (nanos - now.since() > longest) {
            gate.dispatch()
                    .abort(
                            now.own(),
                            new Outcome.TimedOut("It was not done within "
                                    + Duration.ofNanos(longest).toSeconds() + " s."));
        }
    }

    private void awaitEndOfUse(long nanos) {
        boolean unused = drone.control().control().tenure() == null
                && drone.drone().state().link().state() == LinkState.LIVE
                && stands()
                && !gate.isBusy(drone);
        if (!unused) {
            unusedSince = null;
        } else if (unusedSince == null) {
            unusedSince = nanos;
        } else if (nanos - unusedSince > UNUSED_NANOS && nanos - notBefore >= 0) {
            endUse();
        }
    }

    private void endUse() {
        List<OverriddenParameter> values =
                desk.kept(drone.id()).map(ParameterOverrides::values).orElse(List.of());
        if (values.isEmpty()) {
            over();
            return;
        }
        drone.control().enterWhileFree().ifPresent(passage -> {
            // Who arms it in the middle of that finds a part of them.
            prepared = false;
            desk.kept(drone.id()).filter(ParameterOverrides::written).ifPresent(kept -> desk.written(kept, false));
            CloudLossOverrideRecorder notes = notes();
            begin(new RestoreParameters(values, notes), passage, notes, new LinkedHashMap<>());
        });
    }

    private static Outcome replaced(PendingCommand entry) {
        return new Outcome.Superseded("Replaced by: " + entry.open().record().summary() + ".");
    }
}
