package org.dronemap.core.conduct;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.Fixtures;
import org.dronemap.core.cloud.Journal;
import org.dronemap.core.cloud.Lanes;
import org.dronemap.core.cloud.Watchdog;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.lease.Holder;
import org.dronemap.core.operation.Guide;
import org.dronemap.core.operation.Reach;
import org.dronemap.core.operation.Scene;
import org.dronemap.core.operation.Sighting;
import org.dronemap.core.time.SystemTime;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class WheelTest {
    private static final Instant ZERO = Instant.parse("2026-05-01T12:00:00Z");

    private final Lanes lanes = new Lanes(new SystemTime(), 1);
    private final Journal journal = new Journal(new SystemTime());
    private final CloudManager cloud = new CloudManager(
            lanes,
            Watchdog.DEFAULT,
            new SystemTime(),
            new CloudManager.Keeping(
                    new Fixtures.HeapDroneStore(),
                    new Fixtures.HeapCommandStore(),
                    new Fixtures.HeapLeaseStore(),
                    new Fixtures.HeapOwnersStore(),
                    journal),
            () -> new DroneId("d1"));
    private final List<Long> guided = new ArrayList<>();
    private final Wheel<String> wheel =
            new Wheel<>(new DroneCrew(cloud, "test"), new Holder.Operation("o1", "mia", "The trial"), new Guide<>() {
                @Override
                public boolean sighted(Sighting sighting) {
                    guided.add(sighting.number());
                    return sighting.accuracyMeters() < 50;
                }

                @Override
                public Map<DroneId, Setpoint> steer(String state, Scene scene) {
                    return Map.of();
                }
            });

    @AfterEach
    void close() {
        lanes.close();
        journal.close();
    }

    private Reception said(long number, Duration age) {
        Instant sent = ZERO.plusSeconds(number);
        return wheel.sighted(new Sighting(number, sent.minus(age), sent, sent, null, new Geodetic(47, 8), 5, null));
    }

    private void vaguely(long number) {
        Instant sent = ZERO.plusSeconds(number);
        wheel.sighted(new Sighting(number, sent, sent, sent, null, new Geodetic(47, 8), 80, null));
    }

    private Scene turn(long seconds) {
        return wheel.turn("", new Scene(ZERO.plusSeconds(seconds), List.of()));
    }

    @Test
    void takesWhatIsOfNoUseForNoSignThatItMayGoOnAndTellsItFromSilence() {
        said(1, Duration.ZERO);
        turn(1);
        vaguely(2);
        Scene vague = turn(2);
        assertThat(vague.sighted()).isEqualTo(ZERO.plusSeconds(1));
        assertThat(vague.reach()).isEqualTo(Reach.VAGUE);
        assertThat(turn(8).reach()).as("it says nothing any more").isNull();
        vaguely(9);
        wheel.reached(Reach.CUT);
        assertThat(turn(9).reach()).as("the connection tells more").isEqualTo(Reach.CUT);
        wheel.reached(Reach.SPEAKS);
        assertThat(turn(9).reach()).isEqualTo(Reach.VAGUE);
        said(10, Duration.ZERO);
        assertThat(turn(10).reach()).isEqualTo(Reach.SPEAKS);
    }

    private Scene turn() {
        return wheel.turn("", new Scene(ZERO, List.of()));
    }

    @Test
    void takesWhatIsSaidTwiceOnce() {
        assertThat(said(1, Duration.ZERO)).isEqualTo(Reception.TAKEN);
        assertThat(said(2, Duration.ZERO)).isEqualTo(Reception.TAKEN);
        assertThat(said(2, Duration.ZERO)).isEqualTo(Reception.KNOWN);
        assertThat(said(1, Duration.ZERO)).isEqualTo(Reception.KNOWN);
        turn();
        assertThat(guided).containsExactly(1L, 2L);
        assertThat(said(2, Duration.ZERO)).isEqualTo(Reception.KNOWN);
    }

    @Test
    void takesNoMoreThanItCanKeepAndThatAgainLater() {
        long number = 1;
        while (said(number, Duration.ZERO) == Reception.TAKEN) {
            number++;
        }
        assertThat(number).isEqualTo(129);
        assertThat(said(number, Duration.ZERO)).isEqualTo(Reception.CROWDED);
        turn();
        assertThat(said(number, Duration.ZERO)).isEqualTo(Reception.TAKEN);
    }

    /** What a phone kept while it was cut off shows where it went; the drone does not go on for that. */
    @Test
    void takesOldSightingsForNoSignOfLife() {
        said(1, Duration.ZERO);
        assertThat(turn().sighted()).isEqualTo(ZERO.plusSeconds(1));
        said(2, Duration.ofSeconds(30));
        assertThat(turn().sighted()).isEqualTo(ZERO.plusSeconds(1));
        assertThat(guided).containsExactly(1L, 2L);
        said(3, Duration.ofSeconds(1));
        assertThat(turn().sighted()).isEqualTo(ZERO.plusSeconds(3));
    }
}
