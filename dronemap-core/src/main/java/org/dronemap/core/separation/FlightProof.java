package org.dronemap.core.separation;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/**
 * Proof, before a drone sets off, that its whole mission stays clear of the missions that others fly: with it they stay
 * apart even if nobody can command them any more. The later a moment, the less exactly it is known who is where then.
 * Used once, by one thread.
 */
final class FlightProof {
    /** Flights that last longer are proved for so long. */
    private static final double LONGEST_SECONDS = 900;
    /** From now on, and as a share of the time until then. */
    private static final double EARLY_OR_LATE_SECONDS = 2;

    private static final double EARLY_OR_LATE_SHARE = 0.06;

    private final SeparationRound round;
    /** Those that set off now, of which nobody sees a mission flown yet. */
    private final Map<DroneId, TrackSample> setOff = new HashMap<>();

    FlightProof(SeparationRound round) {
        this.round = round;
    }

    /** It sets off as well. */
    void counts(TrackedDrone drone, TrackSample here) {
        setOff.put(drone.id(), here);
    }

    /** Another drone whose mission it would meet if it set off now; empty: it stays clear of all. */
    Optional<TrackedDrone> meets(TrackedDrone drone, TrackSample here) {
        double seconds = Math.min(LONGEST_SECONDS, round.far.missionSeconds(drone, here));
        TrackForecast whole = new TrackForecast(round.plane, seconds, round.picture.now());
        Track mine = whole.mission(drone, here);
        return round.picture.drones().stream()
                .filter(other -> !other.id().equals(drone.id()) && !SeparationRound.isPlannedTogether(drone, other))
                .filter(other -> meet(mine, way(whole, other), round.least(drone, other)))
                .findFirst();
    }

    /** Null: it flies no mission that is known. */
    private @Nullable Track way(TrackForecast whole, TrackedDrone other) {
        TrackSample begins = setOff.get(other.id());
        TrackSample here = begins == null ? round.here(other) : begins;
        boolean flies = other.state().airborne() && other.isLive() && other.steering() == Steering.MISSION;
        return here == null || (begins == null && !flies) ? null : whole.mission(other, here);
    }

    private static boolean meet(Track mine, @Nullable Track yours, Separation least) {
        return yours != null && mine.meets(yours, least, EARLY_OR_LATE_SECONDS, EARLY_OR_LATE_SHARE);
    }
}
