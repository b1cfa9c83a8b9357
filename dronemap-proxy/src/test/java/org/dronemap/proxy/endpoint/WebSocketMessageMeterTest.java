package org.dronemap.proxy.endpoint;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** How long a message is, is known from the headers of its frames, wherever the network cuts them. */
class WebSocketMessageMeterTest {
    private static final int CONTINUED = 0x00;
    private static final int BINARY = 0x02;
    private static final int PING = 0x09;
    private static final int LAST = 0x80;
    private static final int MOST = 70_000;

    private final WebSocketMessageMeter meter = new WebSocketMessageMeter();
    private final ByteArrayOutputStream said = new ByteArrayOutputStream();

    private void frame(int first, int length) {
        said.write(first);
        if (length < 126) {
            said.write(0x80 | length);
        } else if (length < 65_536) {
            said.write(0x80 | 126);
            said.writeBytes(ByteBuffer.allocate(2).putShort((short) length).array());
        } else {
            said.write(0x80 | 127);
            said.writeBytes(ByteBuffer.allocate(8).putLong(length).array());
        }
        said.writeBytes(new byte[] {1, 2, 3, 4});
        byte[] payload = new byte[length];
        new Random(length).nextBytes(payload);
        said.writeBytes(payload);
    }

    /** How many bytes it takes until the meter says no; -1: it never does. */
    private int saysNoAfter(int atOnce) {
        byte[] all = said.toByteArray();
        for (int from = 0; from < all.length; from += atOnce) {
            int length = Math.min(atOnce, all.length - from);
            if (!meter.fits(ByteBuffer.wrap(all, from, length), MOST)) {
                return from + length;
            }
        }
        return -1;
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 3, 7, 1_000, 1_000_000})
    void takesMessagesOfAllLengthsOneAfterTheOther(int atOnce) {
        for (int length : new int[] {0, 1, 125, 126, 65_535, 65_536, MOST}) {
            frame(BINARY | LAST, length);
            frame(PING | LAST, 125);
        }
        frame(BINARY, 30_000);
        frame(PING | LAST, 125);
        frame(CONTINUED, 30_000);
        frame(CONTINUED | LAST, 10_000);
        frame(BINARY | LAST, MOST);

        assertThat(saysNoAfter(atOnce)).isEqualTo(-1);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 1_000_000})
    void refusesAPieceWithWhichAMessageIsTooLong(int atOnce) {
        frame(BINARY, 30_000);
        frame(CONTINUED, 30_000);
        frame(PING | LAST, 125);
        int before = said.size();
        frame(CONTINUED, 10_001);

        assertThat(saysNoAfter(atOnce)).isBetween(before, atOnce == 1 ? before + 8 : said.size());
    }

    @Test
    void refusesALengthThatIsOnlyAnnounced() {
        frame(BINARY | LAST, MOST + 1);

        assertThat(saysNoAfter(1)).isEqualTo(14 - 4 + 4);
    }

    @Test
    void refusesALengthAboveAllNumbers() {
        said.write(BINARY | LAST);
        said.write(0x80 | 127);
        said.writeBytes(ByteBuffer.allocate(12).putLong(-1).array());

        assertThat(saysNoAfter(1)).isEqualTo(14);
    }

    @Test
    void refusesPiecesThatHoldNothingWithoutEnd() {
        frame(BINARY, 0);
        for (int piece = 0; piece < WebSocketMessageMeter.MOST_PIECES; piece++) {
            frame(CONTINUED, 0);
        }

        assertThat(saysNoAfter(1_000_000)).isPositive();
    }
}
