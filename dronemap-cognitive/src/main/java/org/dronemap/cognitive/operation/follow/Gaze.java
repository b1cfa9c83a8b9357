package org.dronemap.cognitive.operation.follow;

import java.time.Instant;
import org.dronemap.cognitive.follow.Followed;
import org.dronemap.cognitive.follow.Motion;
import org.dronemap.cognitive.follow.Whereabouts;
import org.dronemap.core.geo.Spot;

/** Computes the camera's pitch angle towards the target. */
final class Gaze {
    /** Faces are above the ground that phones are not told to be above. */
    private static final double FACE_METERS = 1.5;

    private Gaze() {}

    /** Degrees above the horizon, never above 0: whoever is followed is taken to stand as high as the drone's home. */
    static double degrees(Followed target, Instant now, Whereabouts drone, double homeAmslMeters) {
        Motion there = target.at(now);
        double above = drone.altitudeAmslMeters() - homeAmslMeters - FACE_METERS;
        if (there == null || above <= 0) {
            return 0;
        }
        Spot here = target.plane().spot(drone.point());
        double away = Math.hypot(there.east() - here.eastMeters(), there.north() - here.northMeters());
        return -Math.toDegrees(Math.atan2(above, away));
    }
}
