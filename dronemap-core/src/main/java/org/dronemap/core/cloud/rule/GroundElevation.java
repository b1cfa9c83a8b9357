package org.dronemap.core.cloud.rule;

import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.Position;
import org.jspecify.annotations.Nullable;

/**
 * Elevation above sea level of the ground that one drone took off from; bounds above home are measured from it. It goes
 * with the vehicle while that stands, and stays as it is in the air. Owned by the drone's lane.
 */
public final class GroundElevation {
    /** What an estimate of height wanders by while a vehicle stands; so near, home is that ground. */
    private static final double WANDERS_METERS = 2;

    private @Nullable Double amslMeters;
    /** From an earlier run of the server: it may have landed and started since. */
    private boolean old;

    private @Nullable Double kept;

    /** {@code remembered}: from before; null: nothing. */
    public GroundElevation(@Nullable Double remembered) {
        amslMeters = remembered;
        kept = remembered;
        old = remembered != null;
    }

    @Nullable
    public Double amslMeters() {
        return amslMeters;
    }

    public void at(Position position, @Nullable Home home, boolean stands) {
        Double here = position.altitudeAmslMeters();
        if (stands && here != null) {
            Double height = home == null ? null : Double.valueOf(home.altitudeAmslMeters());
            amslMeters = height != null && Math.abs(height - here) <= WANDERS_METERS ? height : here;
            old = false;
        }
    }

    public void at(Home home, boolean stands) {
        double height = home.altitudeAmslMeters();
        Double before = amslMeters;
        if (before == null) {
            amslMeters = height;
        } else if (old) {
            // In doubt the lower one, with which ceilings are lower.
            amslMeters = Math.min(before, height);
            old = false;
        } else if (stands && Math.abs(height - before) <= WANDERS_METERS) {
            amslMeters = height;
        }
    }

    /** It is to be written down: it left the ground and this is news. True once. */
    public boolean isToBeKept(boolean stands) {
        boolean news = !stands && amslMeters != null && !amslMeters.equals(kept);
        if (news) {
            kept = amslMeters;
        }
        return news;
    }
}
