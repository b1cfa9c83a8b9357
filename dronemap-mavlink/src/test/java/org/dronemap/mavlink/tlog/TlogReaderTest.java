package org.dronemap.mavlink.tlog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedInputStream;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.Attitude;
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

    @Test
    void takesATimeThatLooksLikeAFrameForATime() throws IOException {
        // A heartbeat of version 1, from the last two bytes of the time to the middle of the frame behind it.
        long micros = 1_772_600_767_000_000L & ~0xFFFFL | 0xFE09;
        byte[] disguised = disguised();
        byte[] plain = attitude(7, 1);
        ByteArrayOutputStream tlog = new ByteArrayOutputStream();
        for (byte[] frame : List.of(plain, disguised, plain)) {
            tlog.write(ByteBuffer.allocate(8).putLong(micros).array());
            tlog.write(frame);
        }
        TlogReader reader = new TlogReader(new ByteArrayInputStream(tlog.toByteArray()));

        List<byte[]> read = new ArrayList<>();
        for (TlogReader.Timed next = reader.next(); next != null; next = reader.next()) {
            assertThat(next.micros()).isEqualTo(micros);
            read.add(next.frame().bytes());
        }
        assertThat(read).containsExactly(plain, disguised, plain);
        assertThat(reader.counts().brokenBytes()).isZero();
    }

    private static byte[] attitude(int high, int low) {
        return new FrameWriter(1, 1, 2)
                .frame(new Attitude((long) high << 24, Float.intBitsToFloat(low), 1f, 2f, 3f, 4f, 5f));
    }

    /** One whose fourth and fifth byte of payload are the checksum of a frame that begins two bytes before it. */
    private static byte[] disguised() {
        for (int high = 0; high < 256; high++) {
            for (int low = 0; low < 256; low++) {
                byte[] frame = attitude(high, low);
                ByteBuffer before = ByteBuffer.allocate(2 + frame.length);
                before.put((byte) 0xFE).put((byte) 9).put(frame).flip();
                List<Frame> found = new ArrayList<>();
                new FrameReader().read(before, found::add);
                if (!found.isEmpty() && found.get(0).version() == 1) {
                    return frame;
                }
            }
        }
        throw new AssertionError("every checksum of two bytes was tried");
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
