package org.dronemap.core.conduct;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.cloud.VehicleChannel;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.operation.OperationAction;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.time.TransientFailure;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** How an operation finds out how its commands end, by a clock that is set by hand. */
class OperationCommandsTest extends OperationTestBase {
    private static final Command UPLOAD = new Command.UploadMission(new Mission(List.of(new MissionItem.Land())));

    private long nanos;
    private OperationCommands hands;
    private SavedOperation.Given given;

    @BeforeEach
    void give() {
        DroneGateway crew = new DroneGateway(cloud, "operation");
        LeaseHolder.Operation holder = new LeaseHolder.Operation("o1", "ann", "The trial");
        assertThat(crew.engage(holder, link.id())).isEmpty();
        hands = new OperationCommands(crew, holder, () -> nanos);
        given = new SavedOperation.Given(link.id(), FIRST);
        hands.submit(new OperationAction.SendCommand<String>(link.id(), FIRST, UPLOAD));
        await().until(() -> vehicle.reports.containsKey(FIRST));
        assertThat(hands.outcome(given)).isEmpty();
    }

    @Test
    void waitsForALongTransferAsLongAsItMakesProgress() {
        VehicleChannel.Report report = vehicle.reports.get(FIRST);
        for (int item = 0; item < 10; item++) {
            pass(Duration.ofSeconds(60));
            report.progress(item, 10);
            assertThat(hands.outcome(given)).isEmpty();
        }
        report.ended(new Outcome.Succeeded());

        await().until(() -> hands.outcome(given).equals(Optional.of(new Outcome.Succeeded())));
    }

    @Test
    void givesUpWhatNothingIsHeardOfForThreeMinutes() {
        pass(Duration.ofSeconds(100));
        vehicle.reports.get(FIRST).progress(1, 10);
        assertThat(hands.outcome(given)).isEmpty();
        pass(Duration.ofSeconds(179));
        assertThat(hands.outcome(given)).isEmpty();
        pass(Duration.ofSeconds(2));

        assertThat(hands.outcome(given)).containsInstanceOf(Outcome.Unknown.class);
    }

    @Test
    void tellsWhatTheServerStoppedBeforeFromWhatItCouldNotWriteDown() {
        CommandId second = new CommandId("command-2");
        assertThat(codeOf(second)).isEqualTo(OutcomeCode.NOT_SENT);
        commands.beginFailure = new Unreachable();
        hands.submit(new OperationAction.SendCommand<String>(link.id(), second, UPLOAD));
        assertThat(codeOf(second)).isEqualTo(OutcomeCode.NOT_WRITTEN_DOWN);
        commands.beginFailure = new IllegalStateException("a fault");
        hands.submit(new OperationAction.SendCommand<String>(link.id(), second, UPLOAD));
        assertThat(codeOf(second)).isEqualTo(OutcomeCode.SERVER_FAULT);
        hands.submit(new OperationAction.SendCommand<String>(new DroneId("removed"), second, UPLOAD));
        assertThat(codeOf(second)).isEqualTo(OutcomeCode.DRONE_REMOVED);

        hands.forget(new SavedOperation.Given(link.id(), second));
        assertThat(codeOf(second)).isEqualTo(OutcomeCode.NOT_SENT);
    }

    private OutcomeCode codeOf(CommandId id) {
        return ((Outcome.Refused)
                        hands.outcome(new SavedOperation.Given(link.id(), id)).orElseThrow())
                .cause();
    }

    private static final class Unreachable extends RuntimeException implements TransientFailure {
        private static final long serialVersionUID = 1;

        @Override
        public boolean isTransient() {
            return true;
        }
    }

    private void pass(Duration time) {
        nanos += time.toNanos();
    }
}
