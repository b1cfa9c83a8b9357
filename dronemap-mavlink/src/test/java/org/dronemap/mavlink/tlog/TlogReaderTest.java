package org.dronemap.mavlink.tlog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** On recordings of real vehicles; the expected counts are those of pymavlink. */
class TlogReaderTest {
    @ParameterizedTest
    @CsvSource({
        "ardusub_small.tlog, 35912",
        "mavlinkserver_00025.tlog, 30439",
        "ardusub_pymavlink_bug_2023-04-18.tlog, 50136"
    })
    void losesNoGoodMessage(String name, long expected) throws IOException {
        TlogReader reader = read(name);

        assertThat(reader.counts().goodFrames()).isEqualTo(expected);
    }

    @Test
    void countsTheBrokenRuns() throws IOException {
        assertThat(read("ardusub_small.tlog").counts().brokenRuns()).isEqualTo(4);
        assertThat(read("ardusub_pymavlink_bug_2023-04-18.tlog").counts().brokenBytes())
                .isPositive();
    }

    @Test
    void knowsTheTimeOfEachFrame() throws IOException {
        try (InputStream in = open("ardusub_small.tlog")) {
            TlogReader reader = new TlogReader(in);
            TlogReader.Timed first = reader.next();
            TlogReader.Timed last = first;
            for (TlogReader.Timed next = first; next != null; next = reader.next()) {
                assertThat(next.micros()).isGreaterThanOrEqualTo(last.micros());
                last = next;
            }
            assertThat(ChronoUnit.SECONDS.between(instant(first), instant(last)))
                    .isBetween(262L, 264L);
        }
    }

    private static Instant instant(TlogReader.Timed record) {
        return Instant.EPOCH.plus(record.micros(), ChronoUnit.MICROS);
    }

    private static TlogReader read(String name) throws IOException {
        try (InputStream in = open(name)) {
            TlogReader reader = new TlogReader(in);
            while (reader.next() != null) {
                assertThat(reader.bytesRead()).isPositive();
            }
            return reader;
        }
    }

    private static InputStream open(String name) throws IOException {
        String folder = System.getenv("DRONEMAP_TEST_DATA");
        assumeTrue(folder != null, "DRONEMAP_TEST_DATA is not set: recordings of real vehicles not read");
        return new BufferedInputStream(Files.newInputStream(Path.of(folder, "tlogs", name)));
    }
}
