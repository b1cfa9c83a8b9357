package org.dronemap.proxy.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.Map;
import java.util.function.Function;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The same for a long time: {@code DRONEMAP_FUZZ_MINUTES} for each target, 60 unless it says otherwise. */
@Tag("soak")
class FuzzSoakTest {
    private static final Map<String, Function<FuzzBudget, Long>> TARGETS = Map.of(
            "frame reader", ReaderFuzz::run,
            "translators", TranslatorFuzz::run,
            "procedures", ProcedureFuzz::run,
            "signing", SigningFuzz::run,
            "sessions", SessionFuzz::run,
            "messages of robots", PacketFuzz::run);

    @ParameterizedTest
    @ValueSource(strings = {"frame reader", "translators", "procedures", "signing", "sessions", "messages of robots"})
    void survivesHoursOfHostileInput(String target) {
        Duration length =
                Duration.ofMinutes(Long.parseLong(System.getenv().getOrDefault("DRONEMAP_FUZZ_MINUTES", "60")));

        assertThat(TARGETS.get(target).apply(FuzzBudget.lasting(target, length)))
                .isPositive();
    }
}
