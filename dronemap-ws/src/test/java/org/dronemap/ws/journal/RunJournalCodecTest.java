package org.dronemap.ws.journal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Instant;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import org.dronemap.cognitive.operation.run.MissionRunOperation;
import org.dronemap.cognitive.operation.run.ReplanComputation;
import org.dronemap.cognitive.operation.run.RunState;
import org.dronemap.cognitive.operation.run.model.RunInput;
import org.dronemap.cognitive.operation.run.model.RunWaypoint;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandKind;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.command.RestoreParameters;
import org.dronemap.core.command.SetCloudLossAction;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.operation.OperationAction;
import org.dronemap.core.operation.OperationDecision;
import org.dronemap.core.stored.StoredNames;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

class RunJournalCodecTest {
    private static final int ROUNDS = 300;

    private final RunJournalCodec codec = new RunJournalCodec();
    private final RandomValues made = new RandomValues(new Random(7));

    private static Set<Class<?>> records(Class<?> sealed) {
        Set<Class<?>> all = new TreeSet<>((one, other) -> one.getName().compareTo(other.getName()));
        for (Class<?> one : sealed.getPermittedSubclasses()) {
            if (one.isRecord()) {
                all.add(one);
            } else {
                all.addAll(records(one));
            }
        }
        return all;
    }

    @Test
    void writesAnyStateReadsItAndWritesTheSameAgain() {
        for (int round = 0; round < ROUNDS; round++) {
            RunState state = made.of(RunState.class);
            String text = codec.state(state);
            RunState again = codec.state(text);
            assertThat(again).isEqualTo(state);
            assertThat(codec.state(again)).isEqualTo(text);
        }
    }

    @Test
    void writesAnyInputOfEachKindReadsItAndWritesTheSameAgain() {
        for (Class<?> kind : records(RunInput.class)) {
            for (int round = 0; round < ROUNDS / 10; round++) {
                RunInput input = (RunInput) made.of(kind);
                String text = codec.input(input);
                RunInput again = codec.input(text);
                assertThat(again).isEqualTo(input);
                assertThat(codec.input(again)).isEqualTo(text);
            }
        }
    }

    @Test
    void writesWhatRunsAskForSoThatItCanBeReadAgain() {
        ReplanComputation replan = made.of(ReplanComputation.class);
        List<OperationAction<RunInput>> actions = List.of(
                new OperationAction.Compute<>(replan),
                give(new Command.UploadMission(
                        new Mission(List.of(new MissionItem.TakeOff(20), new MissionItem.Land())))),
                give(new Command.StartMission(MissionCloudLossPolicy.RETURN_TO_LAUNCH)),
                give(new Command.SetMode("GUIDED")),
                give(new Command.Arm()),
                give(new Command.Disarm(false)),
                give(new Command.Hold()),
                give(new Command.Land()),
                give(new Command.ReturnToLaunch()),
                give(new Command.ClearMission()),
                give(new Command.PauseMission()),
                give(new Command.TakePicture()));
        for (OperationAction<RunInput> action : actions) {
            String text = codec.write(OperationAction.class, action);
            Object again = codec.read(OperationAction.class, text);
            assertThat(again).isEqualTo(action);
            assertThat(codec.write(OperationAction.class, again)).isEqualTo(text);
        }
    }

    private static OperationAction<RunInput> give(Command command) {
        return new OperationAction.SendCommand<>(new DroneId("d1"), new CommandId("r1-command-1"), command);
    }

    @Test
    void vouchesForTheStateThatADecisionLeadsTo() {
        RunState state = made.of(RunState.class);
        RunState other = made.of(RunState.class);
        OperationDecision<RunState, RunInput> decision = new OperationDecision<>(state, List.of(), "Because.");

        String text = codec.decision(decision);

        assertThat(text)
                .startsWith("{\"actions\":[],\"why\":\"Because.\",\"next\":\"")
                .isEqualTo(
                        codec.decision(new OperationDecision<>(codec.state(codec.state(state)), List.of(), "Because.")))
                .isNotEqualTo(codec.decision(new OperationDecision<>(other, List.of(), "Because.")));
    }

    /** The log of commands has the same names; the sink of a log that is downloaded is no value. */
    @Test
    void callsCommandsAsTheLogOfCommandsDoes() {
        Set<Class<?>> kinds = records(Command.class);
        assertThat(kinds).hasSize(CommandKind.values().length);
        // With what only lives in a process.
        kinds.remove(Command.DownloadLog.class);
        kinds.remove(SetCloudLossAction.class);
        kinds.remove(RestoreParameters.class);

        assertThat(kinds)
                .allSatisfy(kind -> assertThat(StoredNames.of(kind))
                        .isEqualTo(((Command) made.of(kind)).kind().word()));
    }

    @Test
    void readsWhatWasWrittenBeforeAListWasThere() {
        RunWaypoint target = made.of(RunWaypoint.class);
        ObjectNode older = (ObjectNode) new JsonMapper().readTree(codec.write(RunWaypoint.class, target));
        older.remove(List.of("reports", "refusedBy"));

        Object again = codec.read(RunWaypoint.class, older.toString());

        older.putArray("reports");
        assertThat(codec.write(RunWaypoint.class, again)).isEqualTo(older.toString());
    }

    /** Hashes of the states of runs under way go over what is written. */
    @Test
    void writesNothingOfAListThatCameLaterWhileItIsEmpty() {
        RunWaypoint waypoint = RunWaypoint.waiting(made.of(Waypoint.class));

        String text = codec.write(RunWaypoint.class, waypoint);
        String refused = codec.write(RunWaypoint.class, waypoint.refusedBy(new DroneId("d1")));

        assertThat(text).endsWith(",\"leftOut\":false,\"reports\":[]}");
        assertThat(refused).isEqualTo(text.replaceAll("}$", ",\"refusedBy\":[{\"value\":\"d1\"}]}"));
        assertThat(codec.read(RunWaypoint.class, text)).isEqualTo(waypoint);
    }

    @Test
    void takesNothingThatItWouldNotHaveWritten() {
        String text = codec.input(new MissionRunOperation().resumed(Instant.EPOCH));
        assertThat(text).isEqualTo("{\"type\":\"Resumed\",\"at\":\"1970-01-01T00:00:00Z\"}");

        for (String wrong : List.of(
                "",
                "null",
                "[]",
                text + " {}",
                text.replace("Resumed", "resumed"),
                text.replace("\"at\"", "\"when\""),
                text.replace("}", ",\"more\":1}"),
                text.replace("\"1970-01-01T00:00:00Z\"", "null"),
                text.replace("00:00:00Z", "00:00Z"),
                text.replace("\"1970-01-01T00:00:00Z\"", "0"),
                text.replace("{\"type\"", "{\"at\":\"1970-01-01T00:00:00Z\",\"type\""))) {
            assertThatThrownBy(() -> codec.input(wrong)).as(wrong).isInstanceOf(IllegalArgumentException.class);
        }
    }
}
