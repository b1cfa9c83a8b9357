package org.dronemap.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.Heartbeat;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FrameReaderTest {
    private static final Heartbeat BEAT = new Heartbeat(2, 3, 81, 4, 4, 3);

    private final FrameReader reader = new FrameReader();
    private final List<Frame> frames = new ArrayList<>();

    @Test
    void readsFramesSplitAtEveryByte() {
        byte[] bytes = someFrames(3);
        for (byte single : bytes) {
            reader.read(ByteBuffer.wrap(new byte[] {single}), frames::add);
        }

        assertThat(frames).hasSize(6);
        assertThat(Heartbeat.decode(frames.get(0))).isEqualTo(BEAT);
        assertThat(reader.counts().skippedBytes()).isZero();
    }

    @Test
    void readsManyFramesOfBothVersionsFromOneChunk() {
        reader.read(ByteBuffer.wrap(someFrames(500)), frames::add);

        assertThat(frames).hasSize(1000);
        assertThat(frames).extracting(Frame::version).contains(1, 2);
    }

    @Test
    void losesNoGoodFrameToALyingLength() {
        byte[] liar = {(byte) 0xFD, (byte) 255, 0, 0, 1, 1, 1, 0, 0, 0};
        reader.read(ByteBuffer.wrap(liar), frames::add);
        reader.read(ByteBuffer.wrap(someFrames(50)), frames::add);
        reader.endOfInput(frames::add);

        assertThat(frames).hasSize(100);
        assertThat(reader.counts().brokenFrames()).isPositive();
        assertThat(reader.counts().skippedRuns()).isEqualTo(1);
    }

    @Test
    void findsTheFramesAgainAfterPlainText() {
        reader.read(ByteBuffer.wrap("Init ArduCopter V4.5.6 \u00fd\u00fe".getBytes()), frames::add);
        reader.read(ByteBuffer.wrap(someFrames(2)), frames::add);
        reader.endOfInput(frames::add);

        assertThat(frames).hasSize(4);
    }

    @Test
    void dropsAFrameWithAnUnknownIncompatibilityFlag() {
        byte[] frame = new FrameWriter(1, 1, 2).frame(BEAT);
        frame[2] = 4;
        reader.read(ByteBuffer.wrap(frame), frames::add);
        reader.endOfInput(frames::add);

        assertThat(frames).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "1, 2", "2, 1", "2, 2"})
    void believesNoFrameWithAnyBitOfItsChecksumWrong(int version, int fromTheEnd) {
        byte[] right = new FrameWriter(1, 1, version).frame(BEAT);
        for (int bit = 0; bit < 8; bit++) {
            byte[] wrong = right.clone();
            wrong[wrong.length - fromTheEnd] ^= (byte) (1 << bit);
            reader.read(ByteBuffer.wrap(wrong), frames::add);
            reader.endOfInput(frames::add);
        }

        assertThat(frames).isEmpty();
        assertThat(reader.counts().skippedBytes()).isEqualTo(8L * right.length);
    }

    @Test
    void passesAnUnknownMessageOnUnverified() {
        byte[] frame = {(byte) 0xFD, 1, 0, 0, 7, 1, 1, (byte) 0xF0, (byte) 0xF0, (byte) 0xF0, 42, 1, 2};
        reader.read(ByteBuffer.wrap(frame), frames::add);

        assertThat(frames).singleElement().satisfies(unknown -> {
            assertThat(unknown.verified()).isFalse();
            assertThat(unknown.messageId()).isEqualTo(0xF0F0F0);
            assertThat(unknown.bytes()).isEqualTo(frame);
        });
    }

    @Test
    void neverFailsOnRandomBytes() {
        Random random = new Random(7);
        byte[] chunk = new byte[1000];
        for (int i = 0; i < 1000; i++) {
            random.nextBytes(chunk);
            reader.read(ByteBuffer.wrap(chunk), frames::add);
        }
        reader.endOfInput(frames::add);

        FrameReader.Counts counts = reader.counts();
        long framed = frames.stream().mapToLong(Frame::length).sum();
        assertThat(framed + counts.skippedBytes()).isEqualTo(1_000_000);
    }

    @Test
    void answersZeroBehindTheCutZerosOfVersionTwo() {
        CommandLong command = new CommandLong(1, 1, 400, 0, 1, 0, 0, 0, 0, 0, 0);
        byte[] frame = new FrameWriter(255, 190, 2).frame(command);
        reader.read(ByteBuffer.wrap(frame), frames::add);

        assertThat(frame.length).isLessThan(Frame.HEADER_2 + 33 + 2);
        assertThat(CommandLong.decode(frames.get(0))).isEqualTo(command);
    }

    private static byte[] someFrames(int pairs) {
        FrameWriter one = new FrameWriter(1, 1, 1);
        FrameWriter two = new FrameWriter(2, 1, 2);
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        for (int i = 0; i < pairs; i++) {
            bytes.writeBytes(one.frame(BEAT));
            bytes.writeBytes(two.frame(BEAT));
        }
        return bytes.toByteArray();
    }
}
