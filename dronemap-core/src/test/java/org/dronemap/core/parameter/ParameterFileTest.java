package org.dronemap.core.parameter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class ParameterFileTest {
    private static final List<Parameter> SOME = List.of(
            new Parameter("ACRO_BAL", ParameterType.REAL32, 0.1f),
            new Parameter("RTL_ALT", ParameterType.INT32, 1500),
            new Parameter("SMALL", ParameterType.REAL32, 1.5e-9f),
            new Parameter("WHOLE", ParameterType.INT8, -3));

    @ParameterizedTest
    @EnumSource(ParameterFile.Form.class)
    void readsWhatItWrote(ParameterFile.Form form) {
        List<ParameterValue> read = ParameterFile.read(ParameterFile.write(SOME, form, 7));

        assertThat(ParameterComparison.of(ParameterSet.of(SOME, java.time.Instant.EPOCH), read))
                .isEqualTo(new ParameterComparison(List.of(), SOME.size(), List.of(), List.of()));
    }

    @Test
    void writesTheColumnsOfQGroundControl() {
        assertThat(ParameterFile.write(SOME, ParameterFile.Form.TABLE, 7))
                .startsWith("# Onboard parameters for Vehicle 7\n")
                .contains("7\t1\tRTL_ALT\t1500\t6\n")
                .contains("7\t1\tWHOLE\t-3\t2\n");
    }

    @Test
    void readsWhatGroundStationsWrite() {
        String missionPlanner = "#NOTE: 4/5/2024 Plane: Skywalker\nRTL_ALT,1500\nACRO_BAL,0.1";
        String mavproxy = "ACRO_BAL         0.100000\nRTL_ALT          1500.000000 # cm\n";
        String table = "# Vehicle-Id Component-Id Name Value Type\n1\t1\tACRO_BAL\t0.100000001490116119\t9\n"
                + "1\t1\tRTL_ALT\t1500\t6\n";

        for (String file : List.of(missionPlanner, mavproxy, table)) {
            assertThat(ParameterFile.read(file))
                    .extracting(value -> value.name() + " " + (float) value.value())
                    .containsExactlyInAnyOrder("ACRO_BAL 0.1", "RTL_ALT 1500.0");
        }
    }

    @Test
    void takesTheLastOfTwoValues() {
        assertThat(ParameterFile.read("A,1\nA,2\n")).containsExactly(new ParameterValue("A", 2));
    }

    @ParameterizedTest
    @ValueSource(strings = {"RTL_ALT", "RTL_ALT,abc", "RTL_ALT,1,2", "A_NAME_THAT_IS_TOO_LONG,1", "RTL_ALT,NaN", ",5"})
    void namesTheLineThatIsWrong(String line) {
        assertThatThrownBy(() -> ParameterFile.read("# fine\nGOOD,1\n" + line))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("line 3");
    }
}
