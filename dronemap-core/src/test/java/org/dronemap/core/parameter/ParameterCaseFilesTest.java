package org.dronemap.core.parameter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Parameter files that were reported to fail, out of the test data. */
class ParameterCaseFilesTest {
    private static ParameterFileContent read(String name) throws IOException {
        String folder = System.getenv("DRONEMAP_TEST_DATA");
        assumeTrue(folder != null, "DRONEMAP_TEST_DATA is not set: case files not read");
        return ParameterFile.read(ParameterFile.text(Files.readAllBytes(Path.of(folder, "cases", name))));
    }

    @Test
    void hexadecimalValuesAreRead() throws IOException {
        assertThat(read("params_hex.param"))
                .isEqualTo(new ParameterFileContent(List.of(new ParameterValue("FS_THR_ENABLE", 2)), List.of()));
    }

    @Test
    void valuesOfTheGimbalAreNotTheAutopilots() throws IOException {
        ParameterFileContent content = read("params_two_components.params");

        assertThat(content.values()).containsExactly(new ParameterValue("RTL_ALT", 2000));
        assertThat(content.leftOut())
                .containsExactly(new ParameterFileContent.LeftOut(
                        4,
                        ParameterFileContent.Reason.OTHER_COMPONENT,
                        "RTL_ALT is of component 154, not of the autopilot (component 1)."));
    }
}
