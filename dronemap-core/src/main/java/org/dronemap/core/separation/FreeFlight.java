package org.dronemap.core.separation;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.geo.PlanePoint;

/** Forecasts a drone that somebody steers whose mind nobody here knows. */
final class FreeFlight {
    /** Others are out of its reach after so long, wherever it turns to now. */
    private static final double TURNS_WITHIN_SECONDS = 6;
    /** m/s². */
    private static final double ACCELERATION = 3;

    private static final double MOST_CLIMB = 3;
    /** It may climb or sink by so much before anybody sees it. */
    private static final double HEIGHT_METERS = 2.5;

    private FreeFlight() {}

    /** On as it goes. */
    static Track straight(TrackedDrone drone, TrackSample here, int strides) {
        List<TrackSample> samples = new ArrayList<>();
        GroundVelocity velocity = drone.velocity();
        for (int i = 0; i <= strides; i++) {
            double seconds = i * Track.STRIDE_SECONDS;
            PlanePoint spot = new PlanePoint(
                    here.spot().eastMeters() + velocity.eastward() * seconds,
                    here.spot().northMeters() + velocity.northward() * seconds);
            samples.add(heights(drone, new TrackSample(spot, here.low()), seconds, 0));
        }
        return new Track(samples);
    }

    /** Anywhere that it comes to when it turns now. */
    static Track anywhere(TrackedDrone drone, TrackSample here, int strides) {
        List<TrackSample> samples = new ArrayList<>();
        for (int i = 0; i <= strides; i++) {
            double seconds = Math.min(i * Track.STRIDE_SECONDS, TURNS_WITHIN_SECONDS);
            samples.add(heights(drone, here, seconds, reach(drone, seconds)));
        }
        return new Track(samples);
    }

    /** As fast as it flew lately at most, which it may gather anew. */
    private static double reach(TrackedDrone drone, double seconds) {
        double speed = drone.velocity().speed();
        double fastest = Math.max(speed, drone.pace().cruise());
        double gathering = Math.min(seconds, (fastest - speed) / ACCELERATION);
        return speed * gathering + ACCELERATION * gathering * gathering / 2 + fastest * (seconds - gathering);
    }

    private static TrackSample heights(TrackedDrone drone, TrackSample at, double seconds, double reach) {
        double climbed = climb(drone) * Math.min(seconds, TURNS_WITHIN_SECONDS);
        double doubt = Math.min(HEIGHT_METERS, MOST_CLIMB * seconds);
        return at.at(reach, at.low() + Math.min(0, climbed) - doubt, at.high() + Math.max(0, climbed) + doubt);
    }

    private static double climb(TrackedDrone drone) {
        Motion motion = drone.state().motion();
        Double rate = motion == null ? null : motion.climbRate();
        return rate == null ? 0 : Math.max(-MOST_CLIMB, Math.min(MOST_CLIMB, rate));
    }
}
