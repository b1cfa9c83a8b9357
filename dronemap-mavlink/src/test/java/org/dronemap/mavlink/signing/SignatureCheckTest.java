package org.dronemap.mavlink.signing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.ByteBuffer;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Random;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.SetupSigning;
import org.junit.jupiter.api.Test;

class SignatureCheckTest {
    /** Made with pymavlink: key 00 01 … 1f, system 7, component 1, link 5, timestamp 0x010203040506, sequence 9. */
    private static final String FOREIGN = "fd090100090701000000040000000203510403a53005060504030201a86f2f5919b3";

    /** The same message by the same sender without signing. */
    private static final String FOREIGN_UNSIGNED = "fd09000009070100000004000000020351040342c8";

    private static final Heartbeat BEAT = new Heartbeat(2, 3, 81, 4, 4, 3);
    private static final long MINUTE = 60 * SigningClock.TICKS_PER_SECOND;

    private Instant now = Instant.parse("2026-03-01T12:00:00Z");
    private final SigningKey key = key(0);
    private final SigningClock clock = new SigningClock(() -> now, 0);
    private final SignatureCheck check = new SignatureCheck(key, clock);

    @Test
    void agreesWithAForeignSignature() {
        Frame foreign = read(HexFormat.of().parseHex(FOREIGN));

        assertThat(foreign.signed()).isTrue();
        assertThat(foreign.signatureLinkId()).isEqualTo(5);
        assertThat(foreign.signatureTimestamp()).isEqualTo(0x010203040506L);
        assertThat(key.signed(foreign)).isTrue();
        assertThat(key(1).signed(foreign)).isFalse();
    }

    @Test
    void anUnsignedCopyDiffersInFlagChecksumAndSignatureOnly() {
        Frame bare = read(HexFormat.of().parseHex(FOREIGN)).withoutSignature();

        assertThat(HexFormat.of().formatHex(bare.bytes())).isEqualTo(FOREIGN_UNSIGNED);
        assertThat(bare.withoutSignature()).isSameAs(bare);
    }

    @Test
    void countsTenMicrosecondsSince2015() {
        assertThat(SigningClock.timestampOf(Instant.parse("2015-01-01T00:00:01.000010Z")))
                .isEqualTo(100_001);
        assertThat(SigningClock.timestampOf(Instant.parse("1999-01-01T00:00:00Z")))
                .isZero();
    }

    @Test
    void timestampsRiseWhileTheClockStandsStillOrGoesBack() {
        SigningClock two = new SigningClock(() -> now, 0);
        long first = two.next();
        long second = two.next();
        now = now.minusSeconds(3600);

        assertThat(second).isEqualTo(first + 1);
        assertThat(two.next()).isEqualTo(first + 2);
        assertThat(two.now()).isEqualTo(first + 2);
    }

    @Test
    void startsAtTheStoredTimestampWhenTheClockIsBehindIt() {
        long stored = SigningClock.timestampOf(now) + MINUTE;

        assertThat(new SigningClock(() -> now, stored).next()).isEqualTo(stored + 1);
        assertThat(new SigningClock(() -> now, 17).now()).isEqualTo(SigningClock.timestampOf(now));
    }

    @Test
    void acceptsWhatItsOwnKeySignedOnceOnly() {
        Frame frame = signed(key, 0, SigningClock.timestampOf(now));

        assertThat(check.judge(frame)).isEqualTo(SignatureVerdict.VALID);
        assertThat(check.judge(frame)).isEqualTo(SignatureVerdict.REPLAYED);
    }

    @Test
    void aRefusedFrameOpensTheDoorForNoOther() {
        long ticks = SigningClock.timestampOf(now);
        Frame first = signed(key, 0, ticks);
        Frame second = signed(key, 0, ticks + 5);
        Frame old = signed(key, 9, ticks - MINUTE - 1);
        check.judge(first);
        check.judge(second);

        assertThat(check.judge(first)).isEqualTo(SignatureVerdict.REPLAYED);
        assertThat(check.judge(second)).isEqualTo(SignatureVerdict.REPLAYED);
        assertThat(check.judge(old)).isEqualTo(SignatureVerdict.TOO_OLD);
        assertThat(check.judge(signed(key, 9, ticks - MINUTE - 1))).isEqualTo(SignatureVerdict.TOO_OLD);
    }

    @Test
    void refusesAnUnsignedFrameAndAForeignKey() {
        assertThat(check.judge(read(new FrameWriter(1, 1, 2).frame(BEAT)))).isEqualTo(SignatureVerdict.UNSIGNED);
        assertThat(check.judge(read(new FrameWriter(1, 1, 1).frame(BEAT)))).isEqualTo(SignatureVerdict.UNSIGNED);
        assertThat(check.judge(signed(key(1), 0, SigningClock.timestampOf(now))))
                .isEqualTo(SignatureVerdict.BAD_SIGNATURE);
    }

    @Test
    void everyFlippedBitOfTheSignatureIsFound() {
        byte[] good = signed(key, 0, SigningClock.timestampOf(now)).bytes();
        for (int bit = 0; bit < Frame.SIGNATURE_BYTES * 8; bit++) {
            byte[] bad = good.clone();
            bad[good.length - 1 - bit / 8] ^= (byte) (1 << (bit % 8));
            assertThat(check.judge(read(bad))).as("bit %d", bit).isEqualTo(SignatureVerdict.BAD_SIGNATURE);
        }
        assertThat(check.judge(read(good))).isEqualTo(SignatureVerdict.VALID);
    }

    @Test
    void aBadlySignedFrameMovesNeitherClockNorStream() {
        long before = clock.now();
        assertThat(check.judge(signed(key(1), 0, before + 100 * MINUTE))).isEqualTo(SignatureVerdict.BAD_SIGNATURE);

        assertThat(clock.now()).isEqualTo(before);
        assertThat(check.judge(signed(key, 0, before + 1))).isEqualTo(SignatureVerdict.VALID);
    }

    @Test
    void followsAValidFrameThatIsAheadSoThatItsSenderHearsUs() {
        long ahead = clock.now() + 100 * MINUTE;
        assertThat(check.judge(signed(key, 0, ahead))).isEqualTo(SignatureVerdict.VALID);

        assertThat(clock.next()).isEqualTo(ahead + 1);
    }

    @Test
    void theLastMomentOfAllTimeDoesNotStopTheClock() {
        assertThat(check.judge(signed(key, 0, (1L << 48) - 1))).isEqualTo(SignatureVerdict.VALID);

        assertThat(clock.next()).isLessThan(1L << 48);
        assertThat(clock.next()).isLessThan((1L << 48) - 1);
    }

    @Test
    void aNewStreamMayBeAMinuteBehindAndNoMore() {
        long ticks = SigningClock.timestampOf(now);

        assertThat(check.judge(signed(key, 1, ticks - MINUTE - 1))).isEqualTo(SignatureVerdict.TOO_OLD);
        assertThat(check.judge(signed(key, 1, ticks - MINUTE))).isEqualTo(SignatureVerdict.VALID);
        assertThat(check.judge(signed(key, 1, ticks - MINUTE + 1))).isEqualTo(SignatureVerdict.VALID);
    }

    @Test
    void aKnownStreamMayFallBehindTheClock() {
        long ticks = SigningClock.timestampOf(now);
        assertThat(check.judge(signed(key, 1, ticks))).isEqualTo(SignatureVerdict.VALID);
        now = now.plusSeconds(7200);

        assertThat(check.judge(signed(key, 1, ticks + 1))).isEqualTo(SignatureVerdict.VALID);
        assertThat(check.judge(signed(key, 2, ticks + 2))).isEqualTo(SignatureVerdict.TOO_OLD);
    }

    @Test
    void remembersABoundedNumberOfStreams() {
        long ticks = SigningClock.timestampOf(now);
        for (int link = 0; link < SignatureCheck.MOST_STREAMS; link++) {
            assertThat(check.judge(signed(key, link, ticks))).isEqualTo(SignatureVerdict.VALID);
        }

        assertThat(check.judge(signed(key, 200, ticks))).isEqualTo(SignatureVerdict.TOO_MANY_STREAMS);
        assertThat(check.judge(signed(key, 0, ticks + 1))).isEqualTo(SignatureVerdict.VALID);
    }

    @Test
    void aKeyNeverShowsItself() {
        byte[] secret = new byte[SigningKey.BYTES];
        new Random(4).nextBytes(secret);
        SigningKey shy = new SigningKey(secret);
        int[] numbers = new int[SigningKey.BYTES];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = secret[i] & 0xFF;
        }

        assertThat(shy.toString()).isEqualTo("SigningKey[secret]");
        assertThat(new SetupSigning(1, 1, numbers, 7).toString()).doesNotContain(", " + numbers[1] + ",");
        assertThat(shy).isEqualTo(new SigningKey(secret)).isNotEqualTo(key);
        secret[0]++;
        assertThat(shy.secret()).isNotEqualTo(secret);
    }

    @Test
    void aKeyOfAnotherLengthIsRefusedWithoutShowingIt() {
        assertThatThrownBy(() -> new SigningKey(new byte[31]))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("a signing key has 32 bytes, not 31");
    }

    @Test
    void version1CannotBeSigned() {
        FrameWriter old = new FrameWriter(1, 1, 1);
        assertThatThrownBy(() -> old.frame(BEAT, new OutgoingSigner(key, clock, 0)))
                .isInstanceOf(IllegalStateException.class);
    }

    @Test
    void randomBytesBehindAGoodHeaderThrowNothingAndAreNeverValid() {
        Random random = new Random(20_150_101);
        byte[] good = signed(key, 0, SigningClock.timestampOf(now)).bytes();
        for (int round = 0; round < 20_000; round++) {
            byte[] bad = good.clone();
            for (int i = good.length - Frame.SIGNATURE_BYTES; i < good.length; i++) {
                bad[i] = (byte) random.nextInt();
            }
            assertThat(check.judge(read(bad))).isEqualTo(SignatureVerdict.BAD_SIGNATURE);
        }
    }

    private static SigningKey key(int first) {
        byte[] secret = new byte[SigningKey.BYTES];
        for (int i = 0; i < secret.length; i++) {
            secret[i] = (byte) (first + i);
        }
        return new SigningKey(secret);
    }

    /** A heartbeat of 1/1 with just this timestamp. */
    private static Frame signed(SigningKey by, int linkId, long timestamp) {
        SigningClock fixed = new SigningClock(() -> Instant.EPOCH, timestamp - 1);
        return read(new FrameWriter(1, 1, 2).frame(BEAT, new OutgoingSigner(by, fixed, linkId)));
    }

    private static Frame read(byte[] bytes) {
        List<Frame> frames = new ArrayList<>();
        new FrameReader().read(ByteBuffer.wrap(bytes), frames::add);
        assertThat(frames).hasSize(1);
        return frames.get(0);
    }
}
