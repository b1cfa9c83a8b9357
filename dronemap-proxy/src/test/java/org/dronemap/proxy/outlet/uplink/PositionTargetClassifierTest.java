package org.dronemap.proxy.outlet.uplink;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.proxy.outlet.uplink.PositionTargetClassifier.Meaning;
import org.junit.jupiter.api.Test;

class PositionTargetClassifierTest {
    private static final long MILLI = 1_000_000L;

    private final PositionTargetClassifier watch = new PositionTargetClassifier();
    private long now;

    @Test
    void aPlaceSaidAFewTimesIsGoneToOnce() {
        assertThat(said(1, 3, 200)).containsExactly(Meaning.GO_TO, Meaning.SAID_AGAIN, Meaning.SAID_AGAIN);
        now += 5_000 * MILLI;
        assertThat(said(1, 1, 0)).containsExactly(Meaning.GO_TO);
    }

    @Test
    void aPlaceSaidFiveTimesASecondForTwoSecondsLeadsFromThenOn() {
        List<Meaning> meanings = said(1, 20, 200);
        assertThat(meanings.subList(1, 10)).containsOnly(Meaning.SAID_AGAIN);
        assertThat(meanings.subList(10, 20)).containsOnly(Meaning.LEADS);
    }

    @Test
    void aPlaceSaidTwiceASecondNeverLeadsAsNothingWouldKeepTheDroneMovingInBetween() {
        assertThat(said(1, 20, 500).subList(1, 20)).containsOnly(Meaning.SAID_AGAIN);
    }

    @Test
    void placesThatChangeLeadAtOnceAndTheLastOfThemToo() {
        said(1, 1, 200);
        assertThat(said(2, 3, 200)).containsOnly(Meaning.LEADS);
    }

    private List<Meaning> said(double north, int times, long everyMillis) {
        Setpoint.Track track = new Setpoint.Track(
                new Geodetic(47 + north / 1_000, 8), Altitude.aboveHome(20), null, Setpoint.Facing.ANY);
        List<Meaning> meanings = new ArrayList<>();
        for (int time = 0; time < times; time++) {
            meanings.add(watch.classify(track, now));
            now += everyMillis * MILLI;
        }
        return meanings;
    }
}
