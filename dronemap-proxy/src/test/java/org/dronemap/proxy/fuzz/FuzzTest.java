package org.dronemap.proxy.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Some hostile input, the same each time; {@link FuzzSoakTest} goes on with others for hours. */
class FuzzTest {
    @Test
    void theFrameReaderFindsGoodFramesBehindAnything() {
        assertThat(ReaderFuzz.run(FuzzBudget.rounds("frame reader", 100_000))).isPositive();
    }

    @Test
    void theTranslatorsMakeSenseOfAnyPayload() {
        assertThat(TranslatorFuzz.run(FuzzBudget.rounds("translators", 80_000))).isPositive();
    }

    @Test
    void everyCommandEndsWhateverTheVehicleAnswers() {
        assertThat(ProcedureFuzz.run(FuzzBudget.rounds("procedures", 1_500))).isPositive();
    }

    @Test
    void onlyARightSignatureThatIsNewIsBelieved() {
        assertThat(SigningFuzz.run(FuzzBudget.rounds("signing", 60_000))).isPositive();
    }

    @Test
    void sessionsSurviveHostileVehicles() {
        assertThat(SessionFuzz.run(FuzzBudget.rounds("sessions", 30_000))).isPositive();
    }

    @Test
    void anythingInJsonIsAMessageOfARobotOrSaysWhyItIsNone() {
        assertThat(PacketFuzz.run(FuzzBudget.rounds("messages of robots", 6_000)))
                .isPositive();
    }
}
