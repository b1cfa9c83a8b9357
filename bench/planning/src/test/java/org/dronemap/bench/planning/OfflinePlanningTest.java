package org.dronemap.bench.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Places on the ground, planned without a server. */
class OfflinePlanningTest {
    @Test
    void tellsWhenTheLastDroneIsBack(@TempDir Path folder) throws IOException {
        Path places = Files.write(
                folder.resolve("places"),
                List.of("drone 47.4 8.5 488", "waypoint 47.41 8.5 548", "waypoint 47.42 8.5 548"));
        ByteArrayOutputStream told = new ByteArrayOutputStream();
        OfflinePlanning.run(
                new String[] {places.toString(), "1", "0.1", "0.1"},
                new PrintStream(told, true, StandardCharsets.UTF_8));

        // 4.4 km there and back at 8 m/s, and the climb.
        double seconds =
                Double.parseDouble(told.toString(StandardCharsets.UTF_8).strip().split(" ", 2)[1]);
        assertThat(seconds).isBetween(4_448 / 8.0, 4_448 / 8.0 + 120);
        assertThatThrownBy(() -> OfflinePlanning.run(new String[0], System.out)).hasMessageStartingWith("wants PLACES-FILE");
    }
}
