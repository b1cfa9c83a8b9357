package org.dronemap.proxy.mavlink.translate;

import org.dronemap.mavlink.message.EkfStatusReport;
import org.dronemap.mavlink.message.SysStatus;
import org.jspecify.annotations.Nullable;

/**
 * Tells whether a vehicle can be armed and led: what its pre-arm checks say, and whether its estimator knows where it
 * is. The checks alone are of the mode that it is in, and pass in one that a pilot flies in long before the cloud can
 * lead it.
 */
final class ReadinessReports {
    private static final long PREARM_CHECK = 0x1000_0000L;
    /** POS_HORIZ_REL, POS_HORIZ_ABS, PRED_POS_HORIZ_REL, PRED_POS_HORIZ_ABS: known, or will be once it is armed. */
    private static final int KNOWS_ITS_PLACE = 8 | 16 | 256 | 512;

    private @Nullable Boolean checksPass;
    private @Nullable Boolean knowsItsPlace;

    /** Null: nothing is known of its checks. */
    @Nullable
    Boolean received(SysStatus message) {
        checksPass = (message.onboardControlSensorsPresent() & PREARM_CHECK) == 0
                ? null
                : (Boolean) ((message.onboardControlSensorsHealth() & PREARM_CHECK) != 0);
        return ready();
    }

    @Nullable
    Boolean received(EkfStatusReport message) {
        knowsItsPlace = isPlaceKnown(message);
        return ready();
    }

    static boolean isPlaceKnown(EkfStatusReport message) {
        return (message.flags() & KNOWS_ITS_PLACE) != 0;
    }

    /** Who tells nothing of its estimator is taken at the word of its checks. */
    private @Nullable Boolean ready() {
        Boolean pass = checksPass;
        return pass == null ? null : (Boolean) (pass && !Boolean.FALSE.equals(knowsItsPlace));
    }
}
