package org.dronemap.cognitive.operation.follow;

import java.time.Instant;
import org.dronemap.cognitive.follow.PlanarMotion;
import org.dronemap.cognitive.follow.TrackedTarget;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.separation.DroneFix;

/** Computes the pitch at which the camera of a following drone looks at the phone. */
final class GimbalPitch {
    /** Faces are above the ground that phones are not told to be above. */
    private static final double FACE_METERS = 1.5;

    private GimbalPitch() {}

    /** Degrees above the horizon, never above 0: whoever is followed is taken to stand as high as the drone's home. */
    static double degrees(TrackedTarget target, Instant now, DroneFix drone, double homeAmslMeters) {
        PlanarMotion there = target.at(now);
        double above = drone.altitudeAmslMeters() - homeAmslMeters - FACE_METERS;
        if (there == null || above <= 0) {
            return 0;
        }
        PlanePoint here = target.plane().spot(drone.point());
        double away = Math.hypot(there.east() - here.eastMeters(), there.north() - here.northMeters());
        return -Math.toDegrees(Math.atan2(above, away));
    }
}
