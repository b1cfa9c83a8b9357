package org.dronemap.core.process;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class SafeModeTest {
    private static final Instant NOW = Instant.parse("2026-05-04T10:00:00Z");
    private static final PeerPattern BAD = PeerPattern.at("10.0.0.7", 14550);
    private static final PeerPattern GOOD = PeerPattern.at("10.0.0.8", 14550);

    @Test
    void threeEndsWithinTwoMinutesAskForCare() {
        assertThat(after(end(120), end(60), end(1)).isActive()).isTrue();
        assertThat(after(end(122), end(60), end(1)).isActive()).isFalse();
        assertThat(after(end(159), end(100), end(40)).isActive())
                .as("after a start that took 40 s")
                .isTrue();
        assertThat(after(end(241), end(181), end(121)).isActive())
                .as("long ago")
                .isFalse();
        assertThat(after(end(2), end(1)).isActive()).isFalse();
        assertThat(after(end(500), end(400), end(300), end(2)).ends()).isEmpty();
    }

    @Test
    void whoWasThereAtTwoEndsIsRefusedAndNobodyElse() {
        SafeMode precautions = after(end(30, BAD, GOOD), end(20), end(10, BAD));

        assertThat(precautions.refused()).containsExactly(BAD);
        assertThat(precautions.refuses(new PeerPattern("10.0.0.7", 14550, 3))).isTrue();
        assertThat(precautions.refuses(GOOD)).isFalse();
        assertThat(precautions.refuses(PeerPattern.at("10.0.0.7", 14551))).isFalse();
    }

    @Test
    void aVehicleThatComesFromAnotherPortEachTimeIsRefusedAtAnyPort() {
        SafeMode precautions = after(
                end(30, new PeerPattern("10.0.0.7", 4001, 3), new PeerPattern("10.0.0.7", 4001, PeerPattern.ANY)),
                end(20, new PeerPattern("10.0.0.7", 4002, 3), new PeerPattern("10.0.0.7", 4002, PeerPattern.ANY)),
                end(10));

        assertThat(precautions.refuses(new PeerPattern("10.0.0.7", 4003, 3))).isTrue();
        assertThat(precautions.refuses(new PeerPattern("10.0.0.7", 4003, 4))).isFalse();
        assertThat(precautions.refuses(PeerPattern.at("10.0.0.7", 4003))).isFalse();
    }

    @Test
    void aHostIsRefusedWhenNothingNarrowerWasThereTwice() {
        SafeMode precautions =
                after(end(30, PeerPattern.at("10.0.0.7", 4001)), end(20, PeerPattern.at("10.0.0.7", 4002)), end(10));

        assertThat(precautions.refuses(new PeerPattern("10.0.0.7", 4003, 1))).isTrue();
        assertThat(precautions.refuses(GOOD)).isFalse();
    }

    @Test
    void nobodyIsRefusedForBeingThereTwiceAtOneEnd() {
        assertThat(after(end(30, BAD, BAD), end(20), end(10)).refused()).isEmpty();
    }

    @Test
    void whatIsWrittenOfAnEndIsReadAgain() {
        ProcessCrash end = new ProcessCrash(
                NOW, "lane-1", "ThreadDeath\tin\ntwo lines", List.of(BAD, new PeerPattern("/dev/tty USB", 0, 7)));

        ProcessCrash read = ProcessCrash.of(end.text());

        assertThat(read.at()).isEqualTo(NOW);
        assertThat(read.why()).isEqualTo("ThreadDeath in two lines");
        assertThat(read.peers()).isEqualTo(end.peers());
    }

    private static SafeMode after(ProcessCrash... ends) {
        return SafeMode.after(List.of(ends), NOW);
    }

    private static ProcessCrash end(int secondsAgo, PeerPattern... peers) {
        return new ProcessCrash(
                NOW.minusSeconds(secondsAgo),
                "lane-0",
                "It ended.",
                Stream.of(peers).toList());
    }
}
