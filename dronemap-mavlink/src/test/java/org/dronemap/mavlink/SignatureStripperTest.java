package org.dronemap.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.tlog.TlogBuffer;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.Test;

/** What is left of a signed frame in a recording is the frame as it would have come unsigned. */
class SignatureStripperTest {
    private static final int UNKNOWN_SEED = 77;

    @Test
    void aKnownFrameIsAsItWouldHaveComeUnsigned() {
        byte[] unsigned = new FrameWriter(1, 1, 2).frame(new Heartbeat(2, 3, 129, 4, 4, 3));
        byte[] signed = signed(unsigned, MessageTable.checksumSeed(Heartbeat.ID));
        byte[] kept = strip(signed);
        assertThat(kept).isEqualTo(unsigned);
        FrameReader reader = new FrameReader();
        List<Frame> frames = new ArrayList<>();
        reader.read(ByteBuffer.wrap(kept), frames::add);
        assertThat(frames).hasSize(1);
        assertThat(frames.get(0).verified()).isTrue();
    }

    @RepeatedTest(20)
    void aFrameThatNobodyKnowsIsAsItWouldHaveComeUnsigned() {
        Random random = new Random();
        byte[] payload = new byte[1 + random.nextInt(255)];
        random.nextBytes(payload);
        byte[] unsigned = unknown(payload);
        assertThat(strip(signed(unsigned, UNKNOWN_SEED))).isEqualTo(unsigned);
    }

    @Test
    void unsignedFramesAndVersionOneStayByteForByte() {
        byte[] second = new FrameWriter(1, 1, 2).frame(new Heartbeat(2, 3, 129, 4, 4, 3));
        byte[] first = new FrameWriter(1, 1, 1).frame(new Heartbeat(2, 3, 129, 1, 4, 3));
        assertThat(strip(second)).isEqualTo(second);
        assertThat(strip(first)).isEqualTo(first);
    }

    @Test
    void aBufferLeavesTheSigningKeyOut() {
        byte[] setupSigning = new byte[Frame.HEADER_2 + 42 + 2];
        setupSigning[0] = (byte) Frame.MAGIC_2;
        setupSigning[1] = 42;
        setupSigning[8] = 1;
        TlogBuffer buffer = new TlogBuffer(1_000);
        assertThat(buffer.add(5, setupSigning)).isTrue();
        assertThat(buffer.add(5, new Frame(setupSigning, true))).isTrue();
        assertThat(buffer.frames()).isZero();
        assertThat(buffer.length()).isZero();
    }

    @Test
    void aBufferTakesNoMoreThanItsBound() {
        byte[] frame = new FrameWriter(1, 1, 2).frame(new Heartbeat(2, 3, 129, 4, 4, 3));
        TlogBuffer buffer = new TlogBuffer(2 * (8 + frame.length) + 5);
        assertThat(buffer.add(1, frame)).isTrue();
        assertThat(buffer.add(2, frame)).isTrue();
        assertThat(buffer.add(3, frame)).isFalse();
        assertThat(buffer.frames()).isEqualTo(2);
        assertThat(buffer.lastMicros()).isEqualTo(2);
    }

    private static byte[] strip(byte[] frame) {
        byte[] shifted = new byte[frame.length + 3];
        System.arraycopy(frame, 0, shifted, 3, frame.length);
        int length = SignatureStripper.strip(shifted, 3, frame.length);
        return Arrays.copyOfRange(shifted, 3, 3 + length);
    }

    private static byte[] unknown(byte[] payload) {
        byte[] raw = new byte[Frame.HEADER_2 + payload.length + 2];
        raw[0] = (byte) Frame.MAGIC_2;
        raw[1] = (byte) payload.length;
        raw[5] = 1;
        raw[6] = 1;
        raw[9] = 0x7F;
        System.arraycopy(payload, 0, raw, Frame.HEADER_2, payload.length);
        checksum(raw, payload.length, UNKNOWN_SEED);
        return raw;
    }

    private static byte[] signed(byte[] unsigned, int seed) {
        byte[] raw = Arrays.copyOf(unsigned, unsigned.length + Frame.SIGNATURE_BYTES);
        raw[2] |= Frame.SIGNED_FLAG;
        checksum(raw, raw[1] & 0xFF, seed);
        Arrays.fill(raw, unsigned.length, raw.length, (byte) 0x5A);
        return raw;
    }

    private static void checksum(byte[] raw, int payload, int seed) {
        int crc = Crc.add(Crc.add(Crc.START, raw, 1, Frame.HEADER_2 - 1 + payload), seed);
        raw[Frame.HEADER_2 + payload] = (byte) crc;
        raw[Frame.HEADER_2 + payload + 1] = (byte) (crc >>> 8);
    }
}
