package org.dronemap.proxy.roslink;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.regex.Pattern;
import org.dronemap.core.cloud.SendAuthority;
import org.dronemap.core.drone.DroneId;
import org.dronemap.proxy.record.TextMessageTap;
import org.dronemap.proxy.roslink.wire.RoslinkHeader;
import org.dronemap.proxy.roslink.wire.StringOrNumber;
import org.jspecify.annotations.Nullable;

/**
 * Passes the messages of one robot session to the recorder, without keys and without the largest images. Any thread.
 */
final class RobotRecordingTap {
    /** Scans have some kilobytes; pictures and maps are longer. */
    static final int LONGEST_BYTES = 16_384;

    private static final String BLANK = "***";
    private static final int SHORTEST_SECRET = 6;
    /** Whatever follows the name of a key: a text, or anything up to the next field. */
    private static final Pattern KEY = Pattern.compile("(\"key\"\\s*:\\s*)(\"(?:[^\"\\\\]|\\\\.)*+\"|[^\\s,}\"]++)");
    /** A letter or a digit written as its number: a key could hide behind it, and no bridge writes so. */
    private static final Pattern HIDDEN = Pattern.compile("\\\\u00[2-7]");

    private final TextMessageTap tap;

    RobotRecordingTap(TextMessageTap tap) {
        this.tap = tap;
    }

    /** The robot has said that. */
    void received(ByteBuffer message, RoslinkHeader header) {
        if (tap == TextMessageTap.NONE) {
            return;
        }
        int bytes = message.remaining();
        tap.received(
                bytes > LONGEST_BYTES
                        ? null
                        : blanked(StandardCharsets.UTF_8.decode(message).toString(), header.key()),
                bytes);
    }

    /** The robot was told that. */
    void sent(byte[] message, RoslinkHeader header, SendAuthority mandate) {
        if (tap == TextMessageTap.NONE) {
            return;
        }
        tap.sent(blanked(new String(message, StandardCharsets.UTF_8), header.key()), message.length, mandate);
    }

    /** Null when a key may be hidden in it. */
    static @Nullable String blanked(String text, @Nullable StringOrNumber key) {
        if (HIDDEN.matcher(text).find()) {
            return null;
        }
        String blanked = KEY.matcher(text).replaceAll("$1\"" + BLANK + "\"");
        return key == null || key.text().length() < SHORTEST_SECRET ? blanked : blanked.replace(key.text(), BLANK);
    }

    void working(boolean now) {
        tap.working(now);
    }

    void bound(DroneId drone) {
        tap.bound(drone);
    }

    void ended() {
        tap.ended();
    }
}
