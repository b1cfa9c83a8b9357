package org.dronemap.core.separation;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.geo.PlanePoint;

/** Forecasts a drone that somebody steers whose mind nobody here knows. */
final class FreeFlight {
    /** Others are out of its reach after so long, wherever it turns to now. */
    private static final double TURNS_WITHIN_SECONDS = 4.5;
    /** Who steers by hand flies at least as fast as that before anybody can do anything about it. */
    private static final double LEAST_SPEED = 3;
    /** Share of a climb that goes on. */
    private static final double MOST_CLIMB = 3;

    private FreeFlight() {}

    /** On as it goes. */
    static Track straight(TrackedDrone drone, TrackSample here, int strides) {
        List<TrackSample> samples = new ArrayList<>();
        GroundVelocity velocity = drone.velocity();
        double climb = climb(drone);
        for (int i = 0; i <= strides; i++) {
            double seconds = i * Track.STRIDE_SECONDS;
            PlanePoint spot = new PlanePoint(
                    here.spot().eastMeters() + velocity.eastward() * seconds,
                    here.spot().northMeters() + velocity.northward() * seconds);
            double height = here.low() + climb * Math.min(seconds, TURNS_WITHIN_SECONDS);
            samples.add(new TrackSample(spot, Math.min(height, here.low()), Math.max(height, here.high()), 0));
        }
        return new Track(samples);
    }

    /** Anywhere that it comes to when it turns now. */
    static Track anywhere(TrackedDrone drone, TrackSample here, int strides) {
        List<TrackSample> samples = new ArrayList<>();
        double fastest = Math.max(LEAST_SPEED, drone.velocity().speed());
        double climb = climb(drone);
        for (int i = 0; i <= strides; i++) {
            double seconds = Math.min(i * Track.STRIDE_SECONDS, TURNS_WITHIN_SECONDS);
            samples.add(here.at(
                    fastest * seconds,
                    here.low() + Math.min(0, climb) * seconds,
                    here.high() + Math.max(0, climb) * seconds));
        }
        return new Track(samples);
    }

    private static double climb(TrackedDrone drone) {
        Motion motion = drone.state().motion();
        Double rate = motion == null ? null : motion.climbRate();
        return rate == null ? 0 : Math.max(-MOST_CLIMB, Math.min(MOST_CLIMB, rate));
    }
}
