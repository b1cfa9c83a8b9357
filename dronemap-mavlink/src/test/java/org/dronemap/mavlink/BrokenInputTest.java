package org.dronemap.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.Heartbeat;
import org.junit.jupiter.api.Test;

/** Input that has broken parsers: nothing throws, and the good frame behind or inside it is found. */
class BrokenInputTest {
    private static final Heartbeat BEAT = new Heartbeat(2, 3, 81, 4, 4, 3);

    private final List<Frame> frames = new ArrayList<>();

    @Test
    void findsAGoodFrameInsideAFalseFrameOfAnUnknownKind() {
        byte[] good = new FrameWriter(1, 1, 2).frame(BEAT);
        byte[] falseHead = {(byte) 0xFD, (byte) (good.length - 2), 0, 0, 7, 1, 1, (byte) 0xF0, (byte) 0xF0, (byte) 0xF0
        };
        FrameReader reader = new FrameReader();
        reader.read(ByteBuffer.wrap(joined(falseHead, good)), frames::add);

        assertThat(frames).singleElement().satisfies(frame -> {
            assertThat(frame.verified()).isTrue();
            assertThat(Heartbeat.decode(frame)).isEqualTo(BEAT);
        });
    }

    @Test
    void aGoodDatagramEndsTheWaitForAnEarlierLyingLength() {
        FrameReader reader = new FrameReader();
        FrameWriter writer = new FrameWriter(1, 1, 2);
        reader.readDatagram(ByteBuffer.wrap(new byte[] {(byte) 0xFD, (byte) 255, 0, 0, 1}), frames::add);
        reader.readDatagram(ByteBuffer.wrap(writer.frame(BEAT)), frames::add);

        assertThat(frames)
                .singleElement()
                .satisfies(frame -> assertThat(Heartbeat.decode(frame)).isEqualTo(BEAT));
        assertThat(reader.counts().skippedBytes()).isEqualTo(5);
    }

    @Test
    void joinsAFrameThatIsSplitOverDatagramsAtAnyByte() {
        byte[] whole = new FrameWriter(1, 1, 2).frame(new CommandLong(1, 1, 400, 0, 1, 2, 3, 4, 5, 6, 7));
        for (int split = 1; split < whole.length; split++) {
            FrameReader reader = new FrameReader();
            frames.clear();
            reader.readDatagram(ByteBuffer.wrap(whole, 0, split), frames::add);
            reader.readDatagram(ByteBuffer.wrap(whole, split, whole.length - split), frames::add);
            assertThat(frames).as("split at byte %d", split).hasSize(1);
        }
    }

    @Test
    void losesNoUntouchedFrameWhenAnyOneByteIsBroken() {
        FrameWriter writer = new FrameWriter(1, 1, 2);
        byte[] first = writer.frame(new CommandLong(1, 1, 400, 0, 0xFD, 2, 3, 4, 5, 6, 7));
        byte[] second = writer.frame(BEAT);
        Random random = new Random(3);
        for (int broken = 0; broken < first.length; broken++) {
            byte[] stream = joined(first, second);
            stream[broken] ^= (byte) (1 + random.nextInt(255));
            FrameReader reader = new FrameReader();
            frames.clear();
            reader.read(ByteBuffer.wrap(stream), frames::add);
            reader.endOfInput(frames::add);
            assertThat(frames)
                    .as("byte %d broken", broken)
                    .filteredOn(frame -> frame.verified() && frame.messageId() == Heartbeat.ID)
                    .hasSize(1);
        }
    }

    @Test
    void survivesTheSequencesThatOnceBrokeAParser() throws IOException {
        String folder = System.getenv("DRONEMAP_TEST_DATA");
        assumeTrue(folder != null, "DRONEMAP_TEST_DATA is not set: fuzz seeds not read");
        try (Stream<Path> seeds = Files.list(Path.of(folder, "mavlink-fuzz-seeds"))) {
            List<Path> files = seeds.toList();
            assertThat(files).isNotEmpty();
            for (Path file : files) {
                byte[] seed = goFuzzBytes(Files.readString(file, StandardCharsets.UTF_8));
                FrameReader reader = new FrameReader();
                frames.clear();
                reader.read(ByteBuffer.wrap(joined(seed, new FrameWriter(1, 1, 2).frame(BEAT))), frames::add);
                reader.endOfInput(frames::add);
                assertThat(frames).as("after %s", file.getFileName()).anyMatch(Frame::verified);
            }
        }
    }

    /** The {@code []byte("…")} line of Go's fuzz corpus format. */
    private static byte[] goFuzzBytes(String file) {
        String quoted = file.substring(file.indexOf("[]byte(\"") + 8, file.indexOf("\")"));
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        for (int i = 0; i < quoted.length(); i++) {
            if (quoted.charAt(i) != '\\') {
                bytes.writeBytes(quoted.substring(i, i + 1).getBytes(StandardCharsets.UTF_8));
            } else if (quoted.charAt(i + 1) == 'x') {
                bytes.write(Integer.parseInt(quoted.substring(i + 2, i + 4), 16));
                i += 3;
            } else {
                bytes.write("\u0007\b\f\n\r\t\u000b\\\"".charAt("abfnrtv\\\"".indexOf(quoted.charAt(i + 1))));
                i++;
            }
        }
        return bytes.toByteArray();
    }

    private static byte[] joined(byte[]... parts) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        for (byte[] part : parts) {
            bytes.writeBytes(part);
        }
        return bytes.toByteArray();
    }
}
