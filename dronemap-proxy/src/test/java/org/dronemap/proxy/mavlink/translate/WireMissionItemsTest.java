package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.proxy.mavlink.procedure.MissionUpload.Span;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class WireMissionItemsTest {
    private static final MissionItemInt HOME = item(16, 0f, 470_000_000, 0f);
    private static final MissionItemInt ONE = item(16, 2f, 475_000_000, 30f);

    private static MissionItemInt item(int command, float hold, int x, float z) {
        return new MissionItemInt(1, 1, 1, 3, command, 0, 1, hold, 1f, 2f, Float.NaN, x, 80_000_000, z, 0);
    }

    private static String hash(MissionItemInt item) {
        return WireMissionItems.hash(List.of(HOME, item), 1);
    }

    static Stream<UnaryOperator<MissionItemInt>> changes() {
        return Stream.of(
                m -> copy(m, 17, 3, m.param1(), m.x(), m.z()),
                m -> copy(m, 16, 0, m.param1(), m.x(), m.z()),
                m -> copy(m, 16, 3, 2.5f, m.x(), m.z()),
                m -> copy(m, 16, 3, m.param1(), m.x() + 1, m.z()),
                m -> copy(m, 16, 3, m.param1(), m.x(), 30.01f));
    }

    private static MissionItemInt copy(MissionItemInt m, int command, int frame, float hold, int x, float z) {
        return new MissionItemInt(
                1, 1, 1, frame, command, 0, 1, hold, m.param2(), m.param3(), m.param4(), x, m.y(), z, 0);
    }

    @ParameterizedTest
    @MethodSource("changes")
    void givesAnotherHashForEveryChange(UnaryOperator<MissionItemInt> change) {
        assertThat(hash(change.apply(ONE))).isNotEqualTo(hash(ONE)).hasSize(32);
    }

    @Test
    void givesTheSameHashForWhatOnlyReadingsDifferIn() {
        MissionItemInt readByAnother =
                new MissionItemInt(255, 190, 7, 6, 16, 1, 1, 2f, 1f, 2f, -Float.NaN, 475_000_000, 80_000_000, 30f, 0);

        assertThat(hash(readByAnother)).isEqualTo(hash(ONE));
        assertThat(WireMissionItems.hash(List.of(ONE, ONE), 1)).isEqualTo(hash(ONE));
    }

    @Test
    void findsTheSpanOfWhatDiffers() {
        List<MissionItemInt> held = List.of(HOME, ONE, ONE, ONE, ONE);
        List<MissionItemInt> wanted =
                List.of(ONE, ONE, item(16, 9f, 475_000_000, 30f), ONE, item(16, 2f, 475_000_100, 30f));

        assertThat(WireMissionItems.difference(held, wanted, 1)).contains(new Span(2, 4));
        assertThat(WireMissionItems.difference(held, held, 1)).isEqualTo(Optional.empty());
        assertThat(WireMissionItems.difference(held, wanted.subList(0, 4), 1)).isEmpty();
        assertThat(WireMissionItems.difference(null, wanted, 1)).isEmpty();
    }
}
