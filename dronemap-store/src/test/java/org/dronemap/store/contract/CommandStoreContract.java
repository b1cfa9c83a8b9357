package org.dronemap.store.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Instant;
import java.util.List;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandPhase;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.CommandStore;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.drone.DroneId;
import org.dronemap.store.StoreException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What every {@link CommandStore} keeps to. */
public abstract class CommandStoreContract {
    private static final DroneId COPTER = new DroneId("copter-1");
    private static final Instant ASKED = Instant.parse("2026-03-04T05:06:07.5Z");
    private static final Instant ENDED = ASKED.plusSeconds(3);

    private CommandStore store;

    /** An empty store. */
    protected abstract CommandStore emptyStore();

    @BeforeEach
    void open() {
        store = emptyStore();
    }

    @Test
    void givesBackWhatWasBegun() {
        CommandRecord command = sent("command-1", COPTER, ASKED);
        assertThat(store.begin(command)).isTrue();
        assertThat(store.command(command.id())).contains(command);
        assertThat(store.command(new CommandId("never-begun"))).isEmpty();
    }

    @Test
    void refusesAnIdThatIsTakenAndWritesNothing() {
        CommandRecord first = sent("command-1", COPTER, ASKED);
        store.begin(first);
        assertThat(store.begin(sent("command-1", new DroneId("other"), ENDED))).isFalse();
        assertThat(store.command(first.id())).contains(first);
    }

    @Test
    void keepsEveryKindOfOutcome() {
        List<Outcome> outcomes = List.of(
                new Outcome.Succeeded(),
                new Outcome.Refused("vehicle", "PreArm: GPS not ready — \"wait\"; 100%", OutcomeCode.VEHICLE_REFUSED),
                new Outcome.Failed("it fell back to LOITER"),
                new Outcome.TimedOut("no answer within 3 s"),
                new Outcome.Superseded("a newer mode change"),
                new Outcome.Unknown("the server was restarted"));
        for (int i = 0; i < outcomes.size(); i++) {
            CommandRecord command = sent("command-" + i, COPTER, ASKED);
            store.begin(command);
            CommandRecord ended = command.ended(outcomes.get(i), ENDED);
            store.finish(ended);
            assertThat(store.command(command.id())).contains(ended);
        }
    }

    @Test
    void keepsACommandThatWasRefusedAtOnce() {
        CommandRecord refused = sent("command-1", COPTER, ASKED)
                .ended(new Outcome.Refused("gate", "Arm first.", OutcomeCode.COMMAND_REFUSED), ASKED);
        assertThat(store.begin(refused)).isTrue();
        assertThat(store.command(refused.id())).contains(refused);
    }

    @Test
    void keepsTheProgressAtTheEnd() {
        CommandRecord command = sent("command-1", COPTER, ASKED);
        store.begin(command);
        CommandRecord ended =
                command.withProgress(new CommandRecord.Progress(3, 7)).ended(new Outcome.Failed("link lost"), ENDED);
        store.finish(ended);
        assertThat(store.command(command.id())).contains(ended);
    }

    @Test
    void refusesToEndWhatWasNeverBegun() {
        CommandRecord ended = sent("command-1", COPTER, ASKED).ended(new Outcome.Succeeded(), ENDED);
        assertThatThrownBy(() -> store.finish(ended)).isInstanceOf(StoreException.class);
        assertThat(store.command(ended.id())).isEmpty();
    }

    @Test
    void keepsTheFirstOutcomeAndRefusesAnother() {
        CommandRecord command = sent("command-1", COPTER, ASKED);
        store.begin(command);
        CommandRecord succeeded = command.ended(new Outcome.Succeeded(), ENDED);
        store.finish(succeeded);
        store.finish(command.ended(new Outcome.Succeeded(), ENDED.plusSeconds(1)));
        assertThatThrownBy(() -> store.finish(command.ended(new Outcome.Failed("late"), ENDED)))
                .isInstanceOf(StoreException.class);
        assertThat(store.command(command.id())).contains(succeeded);
    }

    @Test
    void listsTheNewestOfOneDroneFirstUpToTheLimit() {
        for (int i = 0; i < 5; i++) {
            store.begin(sent("command-" + i, COPTER, ASKED.plusSeconds(i)));
        }
        store.begin(sent("of-another", new DroneId("other"), ENDED));
        assertThat(store.commandsOf(COPTER, 3))
                .extracting(command -> command.id().value())
                .containsExactly("command-4", "command-3", "command-2");
        assertThat(store.commandsOf(new DroneId("nobody"), 3)).isEmpty();
    }

    @Test
    void endsOnlyWhatWasUnderWay() {
        CommandRecord done = sent("command-done", COPTER, ASKED);
        store.begin(done);
        store.finish(done.ended(new Outcome.Succeeded(), ENDED));
        CommandRecord open = sent("command-open", COPTER, ASKED);
        store.begin(open);
        CommandRecord accepted = sent("command-accepted", COPTER, ASKED).withPhase(CommandPhase.ACCEPTED);
        store.begin(accepted);
        Outcome unknown = new Outcome.Unknown("the server was restarted");

        assertThat(store.endUnfinished(unknown, ENDED)).isEqualTo(2);

        assertThat(store.command(open.id())).contains(open.ended(unknown, ENDED));
        assertThat(store.command(accepted.id())).contains(accepted.ended(unknown, ENDED));
        assertThat(store.command(done.id())).contains(done.ended(new Outcome.Succeeded(), ENDED));
        assertThat(store.endUnfinished(unknown, ENDED)).isZero();
    }

    private static CommandRecord sent(String id, DroneId drone, Instant at) {
        return new CommandRecord(
                new CommandId(id),
                drone,
                "alice",
                "rest",
                "arm",
                "arm",
                at,
                CommandPhase.SENT,
                null,
                null,
                null,
                7L,
                "00ff");
    }
}
