package org.dronemap.proxy.mavlink.translate;

import java.nio.ByteBuffer;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.proxy.mavlink.procedure.MissionUpload.Span;
import org.jspecify.annotations.Nullable;

/** Hashes and compares missions as MAVLink items, to tell whether a vehicle still has the mission that is known. */
public final class WireMissionItems {
    private static final double SAME_VALUE = 0.05;
    private static final int SAME_PLACE_E7 = 1;
    private static final int HASH_BYTES = 16;
    private static final int ITEM_BYTES = 36;

    private WireMissionItems() {}

    /**
     * SHA-256 over command, frame, settings and place of each item, its first 32 hexadecimal digits. What differs from
     * reading to reading (who asked, which item is current) and what stands before the mission are left out.
     */
    public static String hash(List<MissionItemInt> items, int itemsBefore) {
        try {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            items.stream().skip(itemsBefore).forEach(item -> digest.update(content(item)));
            return HexFormat.of().formatHex(Arrays.copyOf(digest.digest(), HASH_BYTES));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }

    private static byte[] content(MissionItemInt item) {
        return ByteBuffer.allocate(ITEM_BYTES)
                .putInt(item.command())
                .putInt(plainFrame(item.frame()))
                .putInt(bits(item.param1()))
                .putInt(bits(item.param2()))
                .putInt(bits(item.param3()))
                .putInt(bits(item.param4()))
                .putInt(item.x())
                .putInt(item.y())
                .putInt(bits(item.z()))
                .array();
    }

    /** Not-a-number and zero have many forms that mean the same. */
    private static int bits(float value) {
        return Float.floatToIntBits(value == 0 ? 0f : value);
    }

    /** The INT frames mean the same as the plain ones. */
    private static int plainFrame(int frame) {
        return switch (frame) {
            case 5 -> 0;
            case 6 -> 3;
            case 11 -> 10;
            default -> frame;
        };
    }

    /**
     * Where the wanted items differ from those held, as one span; empty when nothing differs, when the number of items
     * does, or when it is not known what is held.
     */
    static Optional<Span> difference(
            @Nullable List<MissionItemInt> held, List<MissionItemInt> wanted, int itemsBefore) {
        if (held == null || held.size() != wanted.size()) {
            return Optional.empty();
        }
        int first = -1;
        int last = -1;
        for (int index = itemsBefore; index < wanted.size(); index++) {
            if (!same(held.get(index), wanted.get(index))) {
                first = first < 0 ? index : first;
                last = index;
            }
        }
        return first < 0 ? Optional.empty() : Optional.of(new Span(first, last));
    }

    /** The same within what a vehicle may round. */
    public static boolean same(MissionItemInt one, MissionItemInt other) {
        return one.command() == other.command()
                && plainFrame(one.frame()) == plainFrame(other.frame())
                && Math.abs((long) one.x() - other.x()) <= SAME_PLACE_E7
                && Math.abs((long) one.y() - other.y()) <= SAME_PLACE_E7
                && near(one.z(), other.z())
                && near(one.param1(), other.param1())
                && near(one.param2(), other.param2())
                && near(one.param3(), other.param3())
                && near(one.param4(), other.param4());
    }

    private static boolean near(float one, float other) {
        return Math.abs(one - other) <= SAME_VALUE || (Float.isNaN(one) && Float.isNaN(other));
    }
}
