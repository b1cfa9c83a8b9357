package org.dronemap.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.signing.OutgoingSigner;
import org.dronemap.mavlink.signing.SigningClock;
import org.dronemap.mavlink.signing.SigningKey;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.Test;

/** A frame that is handed on as somebody else's is as if that one had made it. */
class FrameCopyTest {
    private static final Heartbeat HEARTBEAT = new Heartbeat(2, 3, 129, 4, 4, 3);
    private static final int UNKNOWN_ID = 60_001;
    private static final int UNKNOWN_SEED = 77;

    private final FrameWriter other = new FrameWriter(42, 1, 2);

    @Test
    void aKnownMessageIsAsTheOtherWouldHaveWrittenIt() {
        for (int version = 1; version <= 2; version++) {
            Frame received = frame(new FrameWriter(1, 1, version).frame(HEARTBEAT));
            byte[] copy = new FrameWriter(42, 1, 2).copy(received, null).orElseThrow();
            assertThat(copy).isEqualTo(new FrameWriter(42, 1, 2).frame(HEARTBEAT));
        }
    }

    @Test
    void numbersRiseOverCopiesAndOwnMessages() {
        Frame received = frame(new FrameWriter(1, 1, 2).frame(HEARTBEAT));
        List<Integer> numbers = new ArrayList<>();
        numbers.add(frame(other.copy(received, null).orElseThrow()).sequence());
        numbers.add(frame(other.frame(HEARTBEAT)).sequence());
        numbers.add(frame(other.copy(received, null).orElseThrow()).sequence());
        assertThat(numbers).containsExactly(0, 1, 2);
    }

    @Test
    void aSignatureIsTakenOffAndAnotherOnePutOn() {
        Frame received = frame(new FrameWriter(1, 1, 2).frame(HEARTBEAT, signer(1)));
        assertThat(received.signed()).isTrue();
        assertThat(other.copy(received, null).orElseThrow()).isEqualTo(new FrameWriter(42, 1, 2).frame(HEARTBEAT));

        Frame signed = frame(other.copy(received, signer(2)).orElseThrow());
        assertThat(key(2).signed(signed)).isTrue();
        assertThat(key(1).signed(signed)).isFalse();
        assertThat(signed.systemId()).isEqualTo(42);
    }

    @RepeatedTest(20)
    void aMessageThatNobodyKnowsKeepsAChecksumThatHolds() {
        Random random = new Random();
        byte[] payload = new byte[1 + random.nextInt(255)];
        random.nextBytes(payload);
        Frame received = frame(unknown(7, random.nextInt(256), payload));
        assertThat(received.verified()).isFalse();
        assertThat(other.copy(received, null).orElseThrow()).isEqualTo(unknown(42, 0, payload));

        byte[] signed = other.copy(received, signer(2)).orElseThrow();
        int length = SignatureStripper.strip(signed, 0, signed.length);
        assertThat(Arrays.copyOf(signed, length)).isEqualTo(unknown(42, 1, payload));
    }

    @Test
    void anUnknownMessageOfVersionOneCannotBeCopied() {
        byte[] raw = {(byte) Frame.MAGIC_1, 1, 0, 1, 1, 3, 5, 0, 0};
        assertThat(MessageTable.find(3)).isNull();
        assertThat(other.copy(frame(raw), null)).isEmpty();
    }

    private static byte[] unknown(int systemId, int sequence, byte[] payload) {
        byte[] raw = new byte[Frame.HEADER_2 + payload.length + 2];
        raw[0] = (byte) Frame.MAGIC_2;
        raw[1] = (byte) payload.length;
        raw[4] = (byte) sequence;
        raw[5] = (byte) systemId;
        raw[6] = 1;
        raw[7] = (byte) UNKNOWN_ID;
        raw[8] = (byte) (UNKNOWN_ID >>> 8);
        System.arraycopy(payload, 0, raw, Frame.HEADER_2, payload.length);
        int end = raw.length - 2;
        int sum = Crc.add(Crc.add(Crc.START, raw, 1, end - 1), UNKNOWN_SEED);
        raw[end] = (byte) sum;
        raw[end + 1] = (byte) (sum >>> 8);
        return raw;
    }

    private static SigningKey key(int number) {
        byte[] secret = new byte[SigningKey.BYTES];
        secret[0] = (byte) number;
        return new SigningKey(secret);
    }

    private static FrameSigner signer(int number) {
        return new OutgoingSigner(key(number), new SigningClock(InstantSource.system(), 0), 0);
    }

    private static Frame frame(byte[] raw) {
        List<Frame> frames = new ArrayList<>();
        FrameReader reader = new FrameReader();
        reader.read(ByteBuffer.wrap(raw), frames::add);
        reader.endOfInput(frames::add);
        assertThat(frames).hasSize(1);
        return frames.get(0);
    }
}
