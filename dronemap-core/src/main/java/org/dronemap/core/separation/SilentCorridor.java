package org.dronemap.core.separation;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.safety.SafetyTimes;

/**
 * Tracks of a drone that is not heard: further on its mission, sooner or later, on its way home from where it missed
 * the cloud, or standing where it was heard last, as one whose fail-safe is off does until its battery is empty.
 */
final class SilentCorridor {
    /** From when it was heard last until its fail-safe acts: of firmware whose time cannot be set, and of all others. */
    private static final List<Double> UNTIL_HOMEWARD_SECONDS =
            List.of(6.0, SafetyTimes.VEHICLE_RETURNS.toSeconds() + 1.0);
    /** What it may be ahead, as a share of the time since: it may climb and sink quicker than planned with. */
    private static final double FASTER = 0.1;
    /** What it may be behind. */
    private static final double SLOWER = 0.2;
    /** Between two places where it may be by now: others have no room between them. */
    private static final double STEP_METERS = 12;

    private static final double MOST_STEPS = 40;
    /** Whoever stops it does so before its fail-safe for a lost cloud acts. */
    private static final double STOPS_WITHIN_SECONDS = SafetyTimes.STOPPED_WITHIN.toSeconds();

    /** Beside what its way takes. */
    private static final double MARGIN_SECONDS = 60;
    /** No battery lasts longer for one that stands in the air. */
    private static final double STANDS_SECONDS = SafetyTimes.LONGEST_HOVER.toSeconds();

    private final TrackForecast forecast;
    private final TrackedDrone drone;
    private final TrackSample from;
    private final double gone;

    SilentCorridor(TrackForecast forecast, TrackedDrone drone, TrackSample from) {
        this.forecast = forecast;
        this.drone = drone;
        this.from = from;
        this.gone = drone.silence().toMillis() / 1_000.0;
    }

    /** None: it must be down by now. */
    List<Track> tracks() {
        List<Track> tracks = new ArrayList<>();
        double home = forecast.homewardSeconds(drone, from) + SafetyTimes.CORRIDOR_KEPT.toSeconds() + MARGIN_SECONDS;
        double mission = forecast.missionSeconds(drone, from) * (1 + SLOWER) + MARGIN_SECONDS;
        boolean flew = drone.isOnMission() && !drone.ahead().isEmpty();
        if (flew && gone < mission) {
            onItsMission(tracks);
        }
        if (gone < Math.max(home, flew ? mission : 0)) {
            onItsWayHome(tracks, flew);
        }
        if (flew && gone < home) {
            standingOnItsWay(tracks);
        } else if (!flew && !drone.comesDown() && gone < STANDS_SECONDS) {
            tracks.add(forecast.standing(from));
        }
        return tracks;
    }

    private void onItsWayHome(List<Track> tracks, boolean flew) {
        tracks.add(forecast.homeward(drone, from, gone));
        for (double until : UNTIL_HOMEWARD_SECONDS) {
            TrackSample missing = flew ? flown(Math.min(gone, until)) : from;
            tracks.add(forecast.homeward(drone, missing, Math.max(0, gone - until)));
        }
    }

    /** Where it is on its mission after so long. */
    private TrackSample flown(double seconds) {
        return forecast.mission(drone, from, seconds, cruise()).samples().get(0);
    }

    /** Somebody at the vehicle, or its own fail-safe, may have stopped it soon after it was heard last. */
    private void standingOnItsWay(List<Track> tracks) {
        double longest = Math.min(gone, STOPS_WITHIN_SECONDS);
        double step = Math.max(1, STEP_METERS / cruise());
        for (double seconds = 0; seconds <= longest; seconds += step) {
            tracks.add(forecast.standing(flown(seconds)));
        }
    }

    private double cruise() {
        return TrackForecast.pace(drone).cruise();
    }

    private void onItsMission(List<Track> tracks) {
        double doubt = gone * (FASTER + SLOWER) * cruise();
        int steps = (int) Math.max(1, Math.min(MOST_STEPS, Math.ceil(doubt / STEP_METERS)));
        for (int step = 0; step <= steps; step++) {
            double flown = gone * (1 + FASTER - (FASTER + SLOWER) * step / steps);
            tracks.add(forecast.mission(drone, from, flown, cruise()));
        }
    }
}
