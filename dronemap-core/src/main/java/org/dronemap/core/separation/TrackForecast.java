package org.dronemap.core.separation;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.ReturnHeight;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.LandingPlace;
import org.dronemap.core.mission.MissionItem;
import org.jspecify.annotations.Nullable;

/** Forecasts the ways that drones may fly in the next seconds from what they show, and what they are meant to do. */
final class TrackForecast {
    /** From the decision until it stands, at full speed: so far it goes on while it brakes. */
    static final int STRIDES_TO_STAND = 5;
    /** Vehicles that were told no other height climb to this before they fly home, in m over it. */
    private static final double RETURN_METERS = 15;
    /** At the top of its take-off, until it has gathered itself for what comes next. */
    private static final double TAKE_OFF_ENDS_SECONDS = 2;
    /** Beyond that an order may not have arrived. */
    private static final Duration UNTIL_OBEYED = Duration.ofMillis(1_500);
    /** Slower over the ground than this it stands. */
    private static final double STANDS_SPEED = 0.7;
    /** Nothing that lies on the ground moves as fast. */
    private static final double FLIES_SPEED = 2;

    private final LocalPlane plane;
    private final int strides;
    private final Instant now;

    TrackForecast(LocalPlane plane, double seconds, Instant now) {
        this.plane = plane;
        this.strides = Track.strides(seconds);
        this.now = now;
    }

    /** What it may do; none where it is on the ground, or nobody knows where it is. */
    List<Track> of(TrackedDrone drone) {
        TrackSample here = here(drone);
        if (here == null || !drone.state().airborne() || lies(drone)) {
            return List.of();
        }
        if (drone.isLost()) {
            return new SilentCorridor(this, drone, here).tracks();
        }
        FlightIntent intent = drone.intent();
        return intent == null ? byItself(drone, here) : meant(drone, here, intent);
    }

    /** One that was taken for a wreck and is seen to fly is in the way of others. */
    private static boolean lies(TrackedDrone drone) {
        return drone.step() == FlightIntent.Step.LIE && (drone.isLost() || drone.speed() < FLIES_SPEED);
    }

    private List<Track> meant(TrackedDrone drone, TrackSample here, FlightIntent intent) {
        boolean late = Duration.between(intent.since(), now).compareTo(UNTIL_OBEYED) > 0;
        return switch (intent.step()) {
            case RISE, FLY, GO ->
                drone.isOnMission() || drone.isLed() ? List.of(flying(drone, here)) : byItself(drone, here);
            case GO_ON ->
                late && drone.waits() ? List.of(mission(drone, here), standing(here)) : List.of(mission(drone, here));
            case STAND -> stands(drone, here, late);
            case COME_HOME -> comesHome(drone, here, intent);
            case LIE -> byItself(drone, here);
        };
    }

    private List<Track> stands(TrackedDrone drone, TrackSample here, boolean late) {
        if (!drone.isOnMission()) {
            return byItself(drone, here);
        }
        Track flies = flying(drone, here);
        Track stops = flies.stopping(STRIDES_TO_STAND);
        return late ? List.of(stops, flies) : List.of(stops);
    }

    private List<Track> comesHome(TrackedDrone drone, TrackSample here, FlightIntent intent) {
        if (!drone.waits()) {
            return byItself(drone, here);
        }
        return intent.commanded() ? List.of(standing(here), homeward(drone, here)) : List.of(standing(here));
    }

    /** As it shows itself, without anybody's intent. */
    private List<Track> byItself(TrackedDrone drone, TrackSample here) {
        Steering steering = drone.steering();
        if (steering == null) {
            return freely(drone, here);
        }
        return switch (steering) {
            case HOME -> List.of(homeward(drone, here));
            case SAFETY -> List.of(homeward(drone, here), down(drone, here));
            case MISSION -> List.of(flying(drone, here));
            case STICKS -> freely(drone, here);
            case ORDERS, STANDS -> drone.handling() == Handling.COMMANDED ? moving(drone, here) : freely(drone, here);
        };
    }

    /** It stands, or still rolls to where it was told to go. */
    private List<Track> moving(TrackedDrone drone, TrackSample here) {
        return drone.speed() < STANDS_SPEED
                ? List.of(standing(here))
                : List.of(straight(drone, here).stopping(STRIDES_TO_STAND));
    }

    /** Somebody steers it whose mind nobody here knows: on as it goes, and anywhere that it can turn to soon. */
    private List<Track> freely(TrackedDrone drone, TrackSample here) {
        return List.of(FreeFlight.straight(drone, here, strides), FreeFlight.anywhere(drone, here, strides));
    }

    Track straight(TrackedDrone drone, TrackSample here) {
        return FreeFlight.straight(drone, here, strides);
    }

    private Track flying(TrackedDrone drone, TrackSample here) {
        return mission(drone, here, 0, drone.speed());
    }

    /** It sets off from a stand. */
    Track mission(TrackedDrone drone, TrackSample here) {
        return mission(drone, here, 0, 0);
    }

    /** {@code moving}: how fast it was there, that long ago. */
    Track mission(TrackedDrone drone, TrackSample from, double ago, double moving) {
        TrackBuilder walk = new TrackBuilder(pace(drone), strides, from, ago, moving);
        fly(walk, drone);
        return walk.track();
    }

    /** How long it flies on with its mission, in seconds. */
    double missionSeconds(TrackedDrone drone, TrackSample from) {
        TrackBuilder walk = new TrackBuilder(pace(drone), 0, from, 0, 0);
        fly(walk, drone);
        return walk.seconds();
    }

    static FlightPace pace(TrackedDrone drone) {
        FlightIntent intent = drone.intent();
        return intent == null || intent.pace() == null ? drone.pace() : intent.pace();
    }

    private void fly(TrackBuilder walk, TrackedDrone drone) {
        for (MissionItem item : drone.ahead()) {
            switch (item.kind()) {
                case WAYPOINT -> {
                    MissionItem.Waypoint waypoint = (MissionItem.Waypoint) item;
                    walk.to(new TrackSample(
                            plane.spot(waypoint.point()), amsl(drone, waypoint.altitude(), walk.last())));
                    walk.waitFor(waypoint.holdSeconds());
                }
                case TAKE_OFF -> {
                    double top = ((MissionItem.TakeOff) item).altitudeMeters();
                    double home = drone.homeAmslMeters().orElse(walk.last().low());
                    walk.to(new TrackSample(
                            walk.last().spot(), Math.max(walk.last().high(), home + top)));
                    walk.waitFor(TAKE_OFF_ENDS_SECONDS);
                }
                case WAIT -> walk.waitFor(((MissionItem.Wait) item).seconds());
                case LAND -> land(walk, drone, ((MissionItem.Land) item).place());
                case RETURN_TO_LAUNCH -> home(walk, drone);
                case OTHER, TAKE_PHOTO, SET_SERVO, LOOK_AT, LOOK_AHEAD -> {}
            }
        }
    }

    private void land(TrackBuilder walk, TrackedDrone drone, @Nullable LandingPlace place) {
        if (place != null) {
            walk.to(new TrackSample(plane.spot(place.point()), walk.last().high()));
        }
        walk.down(ground(drone, walk.last()));
    }

    private static double amsl(TrackedDrone drone, Altitude altitude, TrackSample last) {
        return switch (altitude.reference()) {
            case AMSL -> altitude.meters();
            case HOME ->
                drone.homeAmslMeters().map(home -> home + altitude.meters()).orElse(last.high());
        };
    }

    Track homeward(TrackedDrone drone, TrackSample from) {
        return homeward(drone, from, 0);
    }

    Track homeward(TrackedDrone drone, TrackSample from, double ago) {
        TrackBuilder walk = new TrackBuilder(pace(drone), strides, from, ago, 0);
        home(walk, drone);
        return walk.track();
    }

    /** How long it takes to come home and down, in seconds. */
    double homewardSeconds(TrackedDrone drone, TrackSample from) {
        TrackBuilder walk = new TrackBuilder(pace(drone), 0, from, 0, 0);
        home(walk, drone);
        return walk.seconds();
    }

    private void home(TrackBuilder walk, TrackedDrone drone) {
        Home home = drone.state().home();
        if (home == null) {
            walk.down(ground(drone, walk.last()));
            return;
        }
        PlanePoint there = plane.spot(home.point());
        ReturnHeight set = drone.state().returnHeight();
        double height =
                Math.max(walk.last().high(), home.altitudeAmslMeters() + (set == null ? RETURN_METERS : set.meters()));
        if (walk.last().spot().distanceMeters(there) >= 2) {
            walk.to(new TrackSample(walk.last().spot(), height));
            walk.to(new TrackSample(there, height));
        }
        walk.down(home.altitudeAmslMeters());
    }

    private Track down(TrackedDrone drone, TrackSample from) {
        TrackBuilder walk = new TrackBuilder(pace(drone), strides, from, 0, 0);
        walk.down(ground(drone, from));
        return walk.track();
    }

    private static double ground(TrackedDrone drone, TrackSample here) {
        return drone.homeAmslMeters().orElse(here.low() - RETURN_METERS);
    }

    /** It comes to stand first, and goes there then. */
    Track aside(TrackedDrone drone, TrackSample from, TrackSample to) {
        Track first =
                drone.isOnMission() || drone.isLed() ? flying(drone, from).stopping(STRIDES_TO_STAND) : standing(from);
        List<TrackSample> samples = new ArrayList<>(first.samples().subList(0, STRIDES_TO_STAND));
        TrackBuilder walk = new TrackBuilder(pace(drone), strides, samples.get(samples.size() - 1), 0, 0);
        walk.to(to);
        samples.addAll(walk.track().samples());
        return new Track(samples.subList(0, strides + 1));
    }

    /** It is on its way there, and stands there then. */
    Track onward(TrackedDrone drone, TrackSample from, TrackSample to) {
        TrackBuilder walk = new TrackBuilder(pace(drone), strides, from, 0, drone.speed());
        walk.to(to);
        return walk.track();
    }

    Track standing(TrackSample there) {
        return Track.standing(there, strides);
    }

    /** Null: not known. */
    @Nullable
    TrackSample here(TrackedDrone drone) {
        Geodetic point = drone.point();
        return point == null
                ? null
                : drone.amslMeters()
                        .map(meters -> new TrackSample(plane.spot(point), meters))
                        .orElse(null);
    }
}
