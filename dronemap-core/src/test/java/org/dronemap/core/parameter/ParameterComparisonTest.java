package org.dronemap.core.parameter;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.List;
import org.junit.jupiter.api.Test;

class ParameterComparisonTest {
    private static final Parameter HEIGHT = new Parameter("RTL_ALT", ParameterType.INT16, 1500);
    private static final Parameter GAIN = new Parameter("RATE_P", ParameterType.REAL32, 0.1f);
    private static final ParameterSet VEHICLE = ParameterSet.of(List.of(HEIGHT, GAIN), Instant.EPOCH);

    private static ParameterComparison with(String name, double value) {
        return ParameterComparison.of(VEHICLE, List.of(new ParameterValue(name, value)));
    }

    @Test
    void findsWhatDiffers() {
        ParameterComparison comparison = with("RTL_ALT", 2000);

        assertThat(comparison.different()).containsExactly(new ParameterComparison.Difference(HEIGHT, 2000));
        assertThat(comparison.changes()).containsExactly(new ParameterValue("RTL_ALT", 2000));
    }

    @Test
    void comparesAsFineAsTheTypeTellsApart() {
        assertThat(with("RATE_P", 0.1).same()).isEqualTo(1);
        assertThat(with("RATE_P", 0.1000001).different()).hasSize(1);
    }

    @Test
    void leavesOutWhatTheVehicleDoesNotHaveOrCannotHold() {
        assertThat(with("OTHER", 1).unknown()).containsExactly("OTHER");
        assertThat(with("RTL_ALT", 40_000).unfit()).hasSize(1);
        assertThat(with("RTL_ALT", 40_000).changes()).isEmpty();
    }

    @Test
    void searchesByWordsInAnyOrder() {
        assertThat(VEHICLE.search("alt rtl")).containsExactly(HEIGHT);
        assertThat(VEHICLE.search("")).hasSize(2);
        assertThat(VEHICLE.search("nothing")).isEmpty();
    }
}
