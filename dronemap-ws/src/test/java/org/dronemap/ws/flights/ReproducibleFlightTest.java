package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

/** What a flight of the laboratory comes to hangs on its seed alone: not on the machine, the hour or the virtual machine. */
class ReproducibleFlightTest {
    private static final long LONGEST_SECONDS = 120;

    @Test
    void theSameSeedIsTheSameFlightInAnotherProcessAndAnotherSeedAnotherFlight() throws Exception {
        Process other = begin(1);
        String own = MixedOperationScenario.sum(1);

        assertThat(own).contains("lost, heardAgain", "restarted", "visited=60", ", over, ", "state=done");
        assertThat(end(other)).isEqualTo(own);
        assertThat(MixedOperationScenario.sumOfBeginning(2)).isNotEqualTo(MixedOperationScenario.sumOfBeginning(1));
    }

    private static Process begin(long seed) throws IOException {
        String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
        String classes = System.getProperty("surefire.test.class.path", System.getProperty("java.class.path"));
        return new ProcessBuilder(List.of(
                        java,
                        "-Xmx512m",
                        "-XX:TieredStopAtLevel=1",
                        "-cp",
                        classes,
                        MixedOperationScenario.class.getName(),
                        Long.toString(seed)))
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
    }

    /** The last line that it prints; what is before that is its log. */
    private static String end(Process process) throws IOException, InterruptedException {
        try (var out = process.inputReader(StandardCharsets.UTF_8)) {
            String last = out.lines().reduce("", (before, line) -> line);
            assertThat(process.waitFor(LONGEST_SECONDS, TimeUnit.SECONDS)).isTrue();
            return last;
        } finally {
            process.destroyForcibly();
        }
    }
}
