package org.dronemap.proxy.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

class SequenceGapsTest {
    private static final long MILLI = 1_000_000L;

    private final SequenceGaps gaps = new SequenceGaps();
    private long now;

    private void hear(int... sequences) {
        for (int sequence : sequences) {
            now += 20 * MILLI;
            gaps.count(sequence, now);
        }
    }

    private void expect(long received, long lost, long doubled) {
        assertThat(List.of(gaps.received(), gaps.lost(), gaps.doubled())).containsExactly(received, lost, doubled);
    }

    @Test
    void countsNothingLostOverTheTurnOfTheNumbers() {
        for (int i = 0; i < 1_000; i++) {
            hear(200 + i & 255);
        }
        expect(1_000, 0, 0);
    }

    @Test
    void countsWhatIsMissingAlsoAcrossTheTurn() {
        hear(254, 2, 3, 7);
        expect(4, 3 + 3, 0);
    }

    @Test
    void takesBackWhatOnlyCameLate() {
        hear(10, 13, 11, 14, 12);
        expect(5, 0, 0);
    }

    @Test
    void countsACopyAsACopyWheneverItComes() {
        hear(10, 10, 11, 12, 10, 13, 12);
        expect(4, 0, 3);
    }

    @Test
    void doesNotMissWhatWasSentBeforeItListened() {
        hear(10, 9, 8, 11);
        expect(2, 0, 2);
    }

    @Test
    void takesASenderThatBeginsAnewForThatAndForNoLoss() {
        hear(180, 181, 0, 1, 2);
        expect(5, 0, 0);
    }

    @Test
    void countsALongOutageAfterAPause() {
        hear(10);
        now += 2_000 * MILLI;
        hear(110);
        expect(2, 99, 0);
    }

    @Test
    void findsTheLossOfASeededLinkThatLosesDoublesAndReorders() {
        Random random = new Random(7);
        List<Integer> wire = new ArrayList<>();
        int lost = 0;
        int doubled = 0;
        for (int i = 0; i < 100_000; i++) {
            if (i > 0 && i < 99_990 && random.nextInt(10) == 0) {
                lost++;
                continue;
            }
            wire.add(i & 255);
            if (random.nextInt(20) == 0) {
                wire.add(i & 255);
                doubled++;
            }
        }
        for (int i = 2; i + 4 < wire.size(); i += 5) {
            Collections.swap(wire, i, i + random.nextInt(4));
        }
        wire.forEach(this::hear);

        expect(100_000 - lost, lost, doubled);
    }
}
