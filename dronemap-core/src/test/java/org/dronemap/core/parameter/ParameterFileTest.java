package org.dronemap.core.parameter;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronemap.core.parameter.ParameterFileContent.Reason;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
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
        List<ParameterValue> read =
                ParameterFile.read(ParameterFile.write(SOME, form, 7)).values();

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
            assertThat(ParameterFile.read(file).values())
                    .extracting(value -> value.name() + " " + (float) value.value())
                    .containsExactlyInAnyOrder("ACRO_BAL 0.1", "RTL_ALT 1500.0");
        }
    }

    @Test
    void takesTheLastOfTwoValues() {
        ParameterFileContent read = ParameterFile.read("A,1\nA,2\nB,5\nB,5.0\n");

        assertThat(read.values()).containsExactly(new ParameterValue("A", 2), new ParameterValue("B", 5));
        assertThat(read.leftOut())
                .containsExactly(new ParameterFileContent.LeftOut(
                        2, Reason.REPEATED, "A comes again: 2 counts, and 1 before does not."));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "RTL_ALT",
                "RTL_ALT,abc",
                "RTL_ALT,1,2",
                "RTL_ALT 0,5",
                "A_NAME_THAT_IS_TOO_LONG,1",
                "RTL_ALT,NaN",
                "RTL_ALT,15d",
                "RTL_ALT,0x1p3",
                "2\t1\tRTL_ALT\t3",
                "RTL_ALT,0x",
                "RTL_ALT,",
                ",5",
                "@include other.parm",
                "1\t154\tRTL_ALT\t3\t4",
                "1\t\tRTL_ALT\t3\t4",
                "<html>"
            })
    void anOddLineIsNamedAndTheOthersAreTaken(String line) {
        ParameterFileContent read = ParameterFile.read("# fine\nGOOD,1\n" + line + "\nLAST 2\n");

        assertThat(read.values()).containsExactly(new ParameterValue("GOOD", 1), new ParameterValue("LAST", 2));
        assertThat(read.leftOut())
                .hasSize(1)
                .allMatch(left -> left.line() == 3 && left.why().endsWith("."));
    }

    @ParameterizedTest
    @CsvSource({"RTL_ALT, MALFORMED", "RTL_ALT abc, MALFORMED", "@include other.parm, INSTRUCTION"})
    void aProgramIsToldTheKindOfReason(String line, Reason reason) {
        assertThat(ParameterFile.read("GOOD,1\n" + line).leftOut())
                .extracting(ParameterFileContent.LeftOut::reason)
                .containsExactly(reason);
    }

    @Test
    void valuesOfOtherComponentsAreNotTheAutopilots() {
        ParameterFileContent read = ParameterFile.read("3\t1\tMNT_RATE\t20\t4\n3\t171\tMNT_RATE\t7\t4\n");

        assertThat(read.values()).containsExactly(new ParameterValue("MNT_RATE", 20));
        assertThat(read.leftOut())
                .containsExactly(new ParameterFileContent.LeftOut(
                        2,
                        Reason.OTHER_COMPONENT,
                        "MNT_RATE is of component 171, not of the autopilot (component 1)."));
    }

    @Test
    void valuesOfAnotherVehicleInTheSameFileAreNotThisOnes() {
        ParameterFileContent read = ParameterFile.read("3\t1\tMNT_RATE\t20\t4\n4\t1\tRTL_ALT\t7\t4\n3 1 A_B 0x10 9\n");

        assertThat(read.values()).containsExactly(new ParameterValue("MNT_RATE", 20), new ParameterValue("A_B", 16));
        assertThat(read.leftOut())
                .containsExactly(new ParameterFileContent.LeftOut(
                        2, Reason.OTHER_VEHICLE, "RTL_ALT is of vehicle 4, and the file begins with vehicle 3."));
    }

    @Test
    void filesOfEditorsThatWriteUtf16AreRead() {
        for (String encoding : List.of("UTF-8", "UTF-16", "UTF-16LE", "UTF-16BE")) {
            byte[] file = "\uFEFFRTL_ALT,7\r\n".getBytes(java.nio.charset.Charset.forName(encoding));

            assertThat(ParameterFile.read(ParameterFile.text(file)).values())
                    .as(encoding)
                    .containsExactly(new ParameterValue("RTL_ALT", 7));
        }
    }

    @ParameterizedTest
    @CsvSource({"0x1F, 31", "0X10, 16", "-0x2, -2", "1e3, 1000", "+5, 5", "-.5, -0.5"})
    void readsNumbersAsProgramsWriteThem(String written, double value) {
        for (String line : List.of("A," + written, "A " + written, "A = " + written, "A\t" + written)) {
            assertThat(ParameterFile.read(line))
                    .isEqualTo(new ParameterFileContent(List.of(new ParameterValue("A", value)), List.of()));
        }
    }

    @Test
    void takesWhatIsMarkedAndWhatFollowsAByteOrderMark() {
        assertThat(ParameterFile.read("\uFEFFA 1 @READONLY\r\nB,2\r\n").values())
                .containsExactly(new ParameterValue("A", 1), new ParameterValue("B", 2));
    }

    @Test
    void aValueThatWouldBeRoundedToTheVehiclesOwnDoesNotFit() {
        ParameterSet vehicle = ParameterSet.of(SOME, java.time.Instant.EPOCH);

        ParameterComparison compared = ParameterComparison.of(vehicle, List.of(new ParameterValue("RTL_ALT", 1500.4)));

        assertThat(compared.same()).isZero();
        assertThat(compared.unfit()).hasSize(1);
    }
}
