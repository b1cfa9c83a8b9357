package org.dronemap.core.separation;

import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneId;
import org.jspecify.annotations.Nullable;

/**
 * Proof, before a drone sets off, that the whole of its way stays clear of those that others fly: with it they stay apart
 * even if nobody can command them any more. The later a moment, the less exactly it is known who is where then. Used
 * once, by one thread.
 */
final class FlightProof {
    /** Flights that last longer are proved for so long. */
    private static final double LONGEST_SECONDS = 900;
    /** Vehicles cut corners, and fly past them. */
    private static final double CORNER_METERS = 2;

    /** From now on, and as a share of the time until then. */
    private static final double EARLY_OR_LATE_SECONDS = 1;

    private static final double EARLY_OR_LATE_SHARE = 0.03;
    /** The same of one that is still on the ground. */
    private static final double RISES_EARLY_OR_LATE_SECONDS = 2.5;

    /** From the decision until it rises: it is armed, told to, and its motors come up to speed. */
    private static final double RISES_AFTER_SECONDS = 6;
    /** The same once it is armed. */
    private static final double ARMED_RISES_AFTER_SECONDS = 2.5;
    /** From the decision until it sets off from its stand. */
    private static final double GOES_AFTER_SECONDS = 1;

    /** Whoever waits longer is late by its plan. */
    private static final Duration AT_ONCE = Duration.ofSeconds(3);

    private final SeparationRound round;
    /** Those that set off now, of which nobody sees yet what they fly. */
    private final Map<DroneId, Way> settingOff = new HashMap<>();

    private final Map<DroneId, Optional<Track>> tracks = new HashMap<>();
    private @Nullable TrackForecast forecast;

    /** Aim of a drone that sets off. */
    enum Way {
        MISSION,
        HOME
    }

    FlightProof(SeparationRound round) {
        this.round = round;
    }

    /** It sets off as well. */
    void counts(TrackedDrone drone, Way way) {
        settingOff.put(drone.id(), way);
        tracks.remove(drone.id());
    }

    /** Another drone that it would meet if it set off now; empty: it stays clear of all. */
    Optional<TrackedDrone> meets(TrackedDrone drone, TrackSample here, Way way) {
        TrackForecast whole = new TrackForecast(round.plane, seconds(drone, here, way), round.picture.now());
        Track mine = setsOff(drone, here, way, whole);
        return round.picture.drones().stream()
                .filter(other -> !other.id().equals(drone.id()))
                .filter(other -> track(other)
                        .filter(yours -> meet(mine, yours, drone, other))
                        .isPresent())
                .findFirst();
    }

    /** Those that rise by one plan are apart by it, as long as they keep to its times. */
    private boolean meet(Track mine, Track yours, TrackedDrone drone, TrackedDrone other) {
        boolean asPlanned = SeparationRound.isPlannedTogether(drone, other)
                && drone.step() == FlightIntent.Step.RISE
                && !isLate(drone)
                && !isLate(other);
        Separation least = round.least(drone, other).plus(CORNER_METERS, 0);
        boolean rises = !drone.state().airborne() || !other.state().airborne();
        double seconds = rises ? RISES_EARLY_OR_LATE_SECONDS : EARLY_OR_LATE_SECONDS;
        return !asPlanned && mine.meets(yours, least, seconds, EARLY_OR_LATE_SHARE);
    }

    /** It had to wait for others, on the ground or in the air. */
    private boolean isLate(TrackedDrone drone) {
        Yielding own = round.yielding(drone);
        return own != null && own.hasWaited(drone.id(), AT_ONCE, round.picture.now());
    }

    private double seconds(TrackedDrone drone, TrackSample here, Way way) {
        double seconds =
                way == Way.HOME ? round.far.homewardSeconds(drone, here) : round.far.missionSeconds(drone, here);
        return Math.min(LONGEST_SECONDS, seconds + setsOffAfter(drone));
    }

    private static double setsOffAfter(TrackedDrone drone) {
        if (drone.state().airborne()) {
            return GOES_AFTER_SECONDS;
        }
        return Boolean.TRUE.equals(drone.state().armed()) ? ARMED_RISES_AFTER_SECONDS : RISES_AFTER_SECONDS;
    }

    private static Track setsOff(TrackedDrone drone, TrackSample here, Way way, TrackForecast whole) {
        Track track = way == Way.HOME ? whole.homeward(drone, here) : whole.mission(drone, here);
        return track.after(Track.strides(setsOffAfter(drone)));
    }

    /** Empty: it flies no way that is known to its end. */
    private Optional<Track> track(TrackedDrone other) {
        return tracks.computeIfAbsent(other.id(), id -> {
            TrackSample here = round.here(other);
            Way way = way(other);
            return here == null || way == null
                    ? Optional.empty()
                    : Optional.of(flown(other, here, way).apply(forecast()));
        });
    }

    private Function<TrackForecast, Track> flown(TrackedDrone other, TrackSample here, Way way) {
        if (settingOff.containsKey(other.id())) {
            return whole -> setsOff(other, here, way, whole);
        }
        return whole -> way == Way.HOME ? whole.homeward(other, here) : whole.mission(other, here, 0, other.speed());
    }

    private @Nullable Way way(TrackedDrone other) {
        Way next = settingOff.get(other.id());
        Steering steering = other.steering();
        if (next != null || steering == null || !other.state().airborne() || !other.isLive()) {
            return next;
        }
        return switch (steering) {
            case MISSION -> Way.MISSION;
            case HOME -> Way.HOME;
            case ORDERS, STICKS, STANDS, SAFETY -> null;
        };
    }

    /** As long as the longest flight of all. */
    private TrackForecast forecast() {
        TrackForecast known = forecast;
        if (known == null) {
            double longest = 0;
            for (TrackedDrone drone : round.picture.drones()) {
                TrackSample here = round.here(drone);
                if (here != null) {
                    longest = Math.max(
                            longest, Math.max(seconds(drone, here, Way.MISSION), seconds(drone, here, Way.HOME)));
                }
            }
            known = new TrackForecast(round.plane, longest, round.picture.now());
            forecast = known;
        }
        return known;
    }
}
