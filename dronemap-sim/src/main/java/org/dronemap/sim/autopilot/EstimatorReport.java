package org.dronemap.sim.autopilot;

import org.dronemap.mavlink.message.EkfStatusReport;
import org.dronemap.sim.flight.NavigationEstimator;

/** EKF_STATUS_REPORT of a simulated ArduPilot vehicle: what its estimator knows, as flags seen on a real one. */
public final class EstimatorReport {
    private static final int UNINITIALIZED = 1024;
    private static final int ATTITUDE = 1;
    private static final int HORIZONTAL_SPEED = 2;
    private static final int VERTICAL_SPEED = 4;
    private static final int RELATIVE_PLACE = 8;
    private static final int PLACE = 16;
    private static final int HEIGHT = 32;
    private static final int CONSTANT_PLACE = 128;
    private static final int PREDICTED = 256 | 512;
    private static final int STANDING = ATTITUDE | HORIZONTAL_SPEED | VERTICAL_SPEED | HEIGHT | CONSTANT_PLACE;
    private static final int POSITIONED =
            ATTITUDE | HORIZONTAL_SPEED | VERTICAL_SPEED | RELATIVE_PLACE | PLACE | HEIGHT | PREDICTED;
    private static final long DEAD_RECKONING_MILLIS = 7_300;
    private static final long GIVEN_UP_MILLIS = 15_200;

    private EstimatorReport() {}

    public static EkfStatusReport of(NavigationEstimator navigation, boolean landed) {
        return new EkfStatusReport(flags(navigation, landed), 0, 0, 0, 0, 0, 0);
    }

    private static int flags(NavigationEstimator navigation, boolean landed) {
        if (!navigation.tiltAligned()) {
            return navigation.started() ? 0 : UNINITIALIZED;
        }
        if (!navigation.hadEstimate()) {
            return STANDING;
        }
        long lost = navigation.lostMillis();
        boolean positioned = lost == 0 ? navigation.hasEstimate() : lost < DEAD_RECKONING_MILLIS;
        if (positioned) {
            return POSITIONED;
        }
        return lost < GIVEN_UP_MILLIS ? ATTITUDE | VERTICAL_SPEED | HEIGHT | (landed ? HORIZONTAL_SPEED : 0) : STANDING;
    }
}
