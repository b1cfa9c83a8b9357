package org.dronemap.ws.history;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.history.HistoryEvent;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class NameRedactionTest {
    private static HistoryEvent message(String text) {
        return HistoryEvent.of(new DroneId("drone-1"), Instant.EPOCH, HistoryEvent.Kind.MESSAGE, text);
    }

    /** As versions kept them that did not say whom a message names. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "ann handed control over to bob.",
                "sue took control over from ann: smoke",
                "Contact with ann, who had control, was lost.",
                "ann, who had control, may not command any more.",
                "Nobody took control after ann had it.",
                "The pilot changed the mode to LOITER and has control now, not ann."
            })
    void hidesWhomEarlierMessagesOfControlName(String text) {
        assertThat(NameRedaction.event(message(text)).text()).isEqualTo("Control changed.");
    }

    @Test
    void leavesWhatTheVehicleSaid() {
        assertThat(NameRedaction.event(message("EKF failsafe")).text()).isEqualTo("EKF failsafe");
    }
}
