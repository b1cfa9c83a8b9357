package org.dronemap.core.conduct;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.dronemap.core.cloud.CloudFixtures;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.lane.Lanes;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.cloud.lane.Watchdog;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.core.operation.OperationGuidance;
import org.dronemap.core.operation.OperationObservation;
import org.dronemap.core.operation.ReporterState;
import org.dronemap.core.operation.TargetReport;
import org.dronemap.core.time.RealTime;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class GuidanceExecutorTest {
    private static final Instant ZERO = Instant.parse("2026-05-01T12:00:00Z");

    private final Lanes lanes = new Lanes(new RealTime(), 1);
    private final StoreWriter journal = new StoreWriter(new RealTime());
    private final CloudManager cloud = new CloudManager(
            lanes,
            Watchdog.DEFAULT,
            new RealTime(),
            new CloudManager.Persistence(
                    new CloudFixtures.InMemoryDroneStore(),
                    new CloudFixtures.InMemoryCommandStore(),
                    new CloudFixtures.InMemoryLeaseStore(),
                    new CloudFixtures.InMemoryParameterOverrideStore(),
                    journal),
            () -> new DroneId("d1"));
    private final List<Long> guided = new ArrayList<>();
    private final GuidanceExecutor<String> wheel = new GuidanceExecutor<>(
            new DroneGateway(cloud, "test"),
            new LeaseHolder.Operation("o1", "mia", "The trial"),
            new OperationGuidance<>() {
                @Override
                public boolean reported(TargetReport sighting) {
                    guided.add(sighting.number());
                    return sighting.accuracyMeters() < 50;
                }

                @Override
                public Map<DroneId, Setpoint> steer(String state, OperationObservation scene) {
                    return Map.of();
                }
            });

    @AfterEach
    void close() {
        lanes.close();
        journal.close();
    }

    private TargetReportResult said(long number, Duration age) {
        Instant sent = ZERO.plusSeconds(number);
        return wheel.reported(
                new TargetReport(number, sent.minus(age), sent, sent, null, new Geodetic(47, 8), 5, null));
    }

    private void vaguely(long number) {
        Instant sent = ZERO.plusSeconds(number);
        wheel.reported(new TargetReport(number, sent, sent, sent, null, new Geodetic(47, 8), 80, null));
    }

    private OperationObservation turn(long seconds) {
        return wheel.turn("", new OperationObservation(ZERO.plusSeconds(seconds), List.of()));
    }

    @Test
    void takesWhatIsOfNoUseForNoSignThatItMayGoOnAndTellsItFromSilence() {
        said(1, Duration.ZERO);
        turn(1);
        vaguely(2);
        OperationObservation vague = turn(2);
        assertThat(vague.lastReportAt()).isEqualTo(ZERO.plusSeconds(1));
        assertThat(vague.reach()).isEqualTo(ReporterState.VAGUE);
        assertThat(turn(8).reach()).as("it says nothing any more").isNull();
        vaguely(9);
        wheel.reporterStateChanged(ReporterState.CUT);
        assertThat(turn(9).reach()).as("the connection tells more").isEqualTo(ReporterState.CUT);
        wheel.reporterStateChanged(ReporterState.SPEAKS);
        assertThat(turn(9).reach()).isEqualTo(ReporterState.VAGUE);
        said(10, Duration.ZERO);
        assertThat(turn(10).reach()).isEqualTo(ReporterState.SPEAKS);
    }

    private OperationObservation turn() {
        return wheel.turn("", new OperationObservation(ZERO, List.of()));
    }

    @Test
    void takesWhatIsSaidTwiceOnce() {
        assertThat(said(1, Duration.ZERO)).isEqualTo(TargetReportResult.ACCEPTED);
        assertThat(said(2, Duration.ZERO)).isEqualTo(TargetReportResult.ACCEPTED);
        assertThat(said(2, Duration.ZERO)).isEqualTo(TargetReportResult.DUPLICATE);
        assertThat(said(1, Duration.ZERO)).isEqualTo(TargetReportResult.DUPLICATE);
        turn();
        assertThat(guided).containsExactly(1L, 2L);
        assertThat(said(2, Duration.ZERO)).isEqualTo(TargetReportResult.DUPLICATE);
    }

    @Test
    void takesNoMoreThanItCanKeepAndThatAgainLater() {
        long number = 1;
        while (said(number, Duration.ZERO) == TargetReportResult.ACCEPTED) {
            number++;
        }
        assertThat(number).isEqualTo(129);
        assertThat(said(number, Duration.ZERO)).isEqualTo(TargetReportResult.QUEUE_FULL);
        turn();
        assertThat(said(number, Duration.ZERO)).isEqualTo(TargetReportResult.ACCEPTED);
    }

    /** What a phone kept while it was cut off shows where it went; the drone does not go on for that. */
    @Test
    void takesOldSightingsForNoSignOfLife() {
        said(1, Duration.ZERO);
        assertThat(turn().lastReportAt()).isEqualTo(ZERO.plusSeconds(1));
        said(2, Duration.ofSeconds(30));
        assertThat(turn().lastReportAt()).isEqualTo(ZERO.plusSeconds(1));
        assertThat(guided).containsExactly(1L, 2L);
        said(3, Duration.ofSeconds(1));
        assertThat(turn().lastReportAt()).isEqualTo(ZERO.plusSeconds(3));
    }
}
