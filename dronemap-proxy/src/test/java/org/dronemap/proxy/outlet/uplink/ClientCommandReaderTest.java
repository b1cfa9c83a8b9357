package org.dronemap.proxy.outlet.uplink;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.core.mission.Altitude;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The reference of altitudes of other ground stations: https://mavlink.io/en/messages/common.html#MAV_FRAME. */
class ClientCommandReaderTest {
    @ParameterizedTest
    @CsvSource({"0, AMSL", "5, AMSL", "3, HOME", "6, HOME"})
    void readsEachFrameAsItIsMeant(int frame, Altitude.Reference reference) {
        assertThat(ClientCommandReader.altitude(frame, 20)).isEqualTo(new Altitude(20, reference));
    }

    @ParameterizedTest
    @CsvSource({"1", "2", "10", "11"})
    void takesNoOtherFrame(int frame) {
        assertThat(ClientCommandReader.altitude(frame, 20)).isNull();
    }

    @Test
    void takesNoAltitudeThatIsNoNumber() {
        assertThat(ClientCommandReader.altitude(0, Double.NaN)).isNull();
    }
}
