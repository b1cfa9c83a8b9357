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
import org.dronemap.core.lease.Holder;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.operation.Action;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.time.Outage;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** How an operation finds out how its commands end, by a clock that is set by hand. */
class HandsTest extends WatchHouse {
    private static final Command UPLOAD = new Command.UploadMission(new Mission(List.of(new MissionItem.Land())));

    private long nanos;
    private Hands hands;
    private SavedOperation.Given given;

    @BeforeEach
    void give() {
        DroneCrew crew = new DroneCrew(cloud, "operation");
        Holder.Operation holder = new Holder.Operation("o1", "ann", "The trial");
        assertThat(crew.engage(holder, link.id())).isEmpty();
        hands = new Hands(crew, holder, () -> nanos);
        given = new SavedOperation.Given(link.id(), FIRST);
        hands.give(new Action.Give<String>(link.id(), FIRST, UPLOAD));
        await().until(() -> vehicle.reports.containsKey(FIRST));
        assertThat(hands.end(given)).isEmpty();
    }

    @Test
    void waitsForALongTransferAsLongAsItMakesProgress() {
        VehicleChannel.Report report = vehicle.reports.get(FIRST);
        for (int item = 0; item < 10; item++) {
            pass(Duration.ofSeconds(60));
            report.progress(item, 10);
            assertThat(hands.end(given)).isEmpty();
        }
        report.ended(new Outcome.Succeeded());

        await().until(() -> hands.end(given).equals(Optional.of(new Outcome.Succeeded())));
    }

    @Test
    void givesUpWhatNothingIsHeardOfForThreeMinutes() {
        pass(Duration.ofSeconds(100));
        vehicle.reports.get(FIRST).progress(1, 10);
        assertThat(hands.end(given)).isEmpty();
        pass(Duration.ofSeconds(179));
        assertThat(hands.end(given)).isEmpty();
        pass(Duration.ofSeconds(2));

        assertThat(hands.end(given)).containsInstanceOf(Outcome.Unknown.class);
    }

    @Test
    void tellsWhatTheServerStoppedBeforeFromWhatItCouldNotWriteDown() {
        CommandId second = new CommandId("command-2");
        assertThat(codeOf(second)).isEqualTo(OutcomeCode.NOT_SENT);
        commands.beginFailure = new Unreachable();
        hands.give(new Action.Give<String>(link.id(), second, UPLOAD));
        assertThat(codeOf(second)).isEqualTo(OutcomeCode.NOT_WRITTEN_DOWN);
        commands.beginFailure = new IllegalStateException("a fault");
        hands.give(new Action.Give<String>(link.id(), second, UPLOAD));
        assertThat(codeOf(second)).isEqualTo(OutcomeCode.SERVER_FAULT);
        hands.give(new Action.Give<String>(new DroneId("removed"), second, UPLOAD));
        assertThat(codeOf(second)).isEqualTo(OutcomeCode.DRONE_REMOVED);

        hands.told(new SavedOperation.Given(link.id(), second));
        assertThat(codeOf(second)).isEqualTo(OutcomeCode.NOT_SENT);
    }

    private OutcomeCode codeOf(CommandId id) {
        return ((Outcome.Refused)
                        hands.end(new SavedOperation.Given(link.id(), id)).orElseThrow())
                .cause();
    }

    private static final class Unreachable extends RuntimeException implements Outage {
        private static final long serialVersionUID = 1;

        @Override
        public boolean isPassing() {
            return true;
        }
    }

    private void pass(Duration time) {
        nanos += time.toNanos();
    }
}
