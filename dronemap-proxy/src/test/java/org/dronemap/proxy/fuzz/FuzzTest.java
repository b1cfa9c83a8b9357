package org.dronemap.proxy.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;

/** Half a minute of hostile input, another one each time; a failure names the seed that repeats it. */
class FuzzTest {
    private static final Duration SHORT = Duration.ofSeconds(5);

    @Test
    void theFrameReaderFindsGoodFramesBehindAnything() {
        assertThat(ReaderFuzz.run(new Budget("frame reader", SHORT))).isPositive();
    }

    @Test
    void theTranslatorsMakeSenseOfAnyPayload() {
        assertThat(TranslatorFuzz.run(new Budget("translators", SHORT))).isPositive();
    }

    @Test
    void everyCommandEndsWhateverTheVehicleAnswers() {
        assertThat(ProcedureFuzz.run(new Budget("procedures", SHORT))).isPositive();
    }

    @Test
    void onlyARightSignatureThatIsNewIsBelieved() {
        assertThat(SigningFuzz.run(new Budget("signing", SHORT))).isPositive();
    }

    @Test
    void sessionsSurviveHostileVehicles() {
        assertThat(SessionFuzz.run(new Budget("sessions", SHORT))).isPositive();
    }

    @Test
    void anythingInJsonIsAMessageOfARobotOrSaysWhyItIsNone() {
        assertThat(PacketFuzz.run(new Budget("messages of robots", SHORT))).isPositive();
    }
}
