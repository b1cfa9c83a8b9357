package org.dronemap.ws.environment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class EnvironmentVariablesTest {
    private static final String NAME = "DRONEMAP_SHELVES";

    private static int shelves(String value) {
        return new EnvironmentVariables(Map.of(NAME, value)).whole(NAME, -1, 20, 5);
    }

    @Test
    void areReadWithinTheirBounds() {
        assertThat(shelves("-1")).isEqualTo(-1);
        assertThat(shelves(" 20 ")).isEqualTo(20);
    }

    @Test
    void areAsUsualWhereNothingIsSet() {
        assertThat(shelves(" ")).isEqualTo(5);
        assertThat(new EnvironmentVariables(Map.of()).whole(NAME, -1, 20, 5)).isEqualTo(5);
    }

    @ParameterizedTest
    @ValueSource(strings = {"-2", "21", "1e1", "ten", "1.5", "99999999999"})
    void areRefusedByNameAndValueWithWhatIsAllowed(String value) {
        assertThatThrownBy(() -> shelves(value))
                .isInstanceOf(SetupException.class)
                .hasMessage("DRONEMAP_SHELVES must be a whole number from -1 to 20, not \"" + value + "\".");
    }
}
