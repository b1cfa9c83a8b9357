package org.dronemap.ws.stream;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class StreamEndingTest {
    @ParameterizedTest
    @CsvSource({
        "1001, true, LEFT",
        "1006, true, LEFT",
        "4000, true, RECONNECTING",
        "4000, false, RECONNECTING",
        "1006, false, BROKEN",
        "1008, false, EXPELLED"
    })
    void isToldByCodeAndByWhoeverEndedIt(int code, boolean remote, StreamEnding ending) {
        assertThat(StreamEnding.of(code, remote)).isEqualTo(ending);
    }
}
