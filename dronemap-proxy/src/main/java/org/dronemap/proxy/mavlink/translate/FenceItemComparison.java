package org.dronemap.proxy.mavlink.translate;

import java.util.Locale;
import org.dronemap.core.mission.HeightReference;
import org.dronemap.mavlink.message.MissionItemInt;
import org.jspecify.annotations.Nullable;

/** Compares an item of a fence or of rally points as it was sent with what the vehicle holds. */
final class FenceItemComparison {
    /** What a vehicle that counts in centimetres may round. */
    private static final double SAME_METERS = 0.005;

    private FenceItemComparison() {}

    /** What the vehicle holds instead, as the end of a sentence; null when it holds the same. */
    static @Nullable String difference(MissionItemInt sent, MissionItemInt held) {
        if (sent.command() != held.command()) {
            return "command " + held.command() + " instead of " + sent.command();
        }
        if (sent.x() != held.x() || sent.y() != held.y()) {
            return "at " + place(held) + " instead of " + place(sent);
        }
        if (!isSame(sent.param1(), held.param1())) {
            String what = isCorner(sent.command()) ? "corners" : "m radius";
            return number(held.param1()) + " instead of " + number(sent.param1()) + " " + what;
        }
        boolean hasHeight = sent.command() == FenceCodec.RALLY_POINT || sent.z() != 0 || held.z() != 0;
        boolean sameHeight = isSame(sent.z(), held.z())
                && FenceCodec.reference(sent.frame()).equals(FenceCodec.reference(held.frame()));
        return !hasHeight || sameHeight ? null : "at " + height(held) + " instead of " + height(sent);
    }

    private static boolean isCorner(int command) {
        return command == FenceCodec.POLYGON_INSIDE || command == FenceCodec.POLYGON_OUTSIDE;
    }

    private static boolean isSame(float one, float other) {
        return Math.abs(one - other) <= SAME_METERS;
    }

    private static String place(MissionItemInt item) {
        return String.format(Locale.ROOT, "%.7f, %.7f", item.x() / FenceCodec.E7, item.y() / FenceCodec.E7);
    }

    private static String number(float value) {
        return value == Math.rint(value) ? String.format(Locale.ROOT, "%.0f", value) : Float.toString(value);
    }

    private static String height(MissionItemInt item) {
        HeightReference reference = FenceCodec.reference(item.frame()).orElse(null);
        String from = reference == null
                ? "in frame " + item.frame()
                : switch (reference) {
                    case HOME -> "above home";
                    case AMSL -> "above sea level";
                    case TERRAIN -> "above the ground below";
                };
        return number(item.z()) + " m " + from;
    }
}
