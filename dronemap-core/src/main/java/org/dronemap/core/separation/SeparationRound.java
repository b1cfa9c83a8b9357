package org.dronemap.core.separation;

import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.mission.Altitude;
import org.jspecify.annotations.Nullable;

/** Working memory while one picture of the airspace is looked at. Used once, by one thread. */
final class SeparationRound {
    private static final double AHEAD_SECONDS = 10;
    /** Who goes on must not be stopped again at once. */
    private static final double CLEAR_SECONDS = 14;

    /**
     * One that stands, and whose server is not there any more, climbs by then to come home by itself
     * ({@code SafetyTimes.VEHICLE_RETURNS}): until then it is in nobody's way.
     */
    private static final double LASTING_SECONDS = 28;

    /** Nobody is asked to step farther aside. */
    private static final double ASIDE_METERS = 30;

    private static final double ROOM_METERS = 2;
    /** Heights wander by so much; layers of one plan are exactly as far apart as they must be. */
    private static final double WANDER_METERS = 0.6;

    private static final double THERE_METERS = 1;

    final AirspacePicture picture;
    private final Separation planned;
    private final Separation unplanned;
    final LocalPlane plane;
    final TrackForecast near;
    final TrackForecast far;
    final TrackForecast lasting;
    final Map<DroneId, Yielding> yielding;
    private final List<SeparationOrder> orders = new ArrayList<>();
    private final Map<DroneId, TrackSample> places = new HashMap<>();
    private final Map<DroneId, List<Track>> nearTracks = new HashMap<>();
    private final Map<DroneId, List<Track>> farTracks = new HashMap<>();
    private final Map<DroneId, List<Track>> lastingTracks = new HashMap<>();

    SeparationRound(AirspacePicture picture, Map<DroneId, Yielding> before) {
        this.picture = picture;
        this.planned = picture.least().plus(ROOM_METERS, 0);
        this.unplanned = picture.least().plus(ROOM_METERS, 2 * WANDER_METERS);
        this.plane = new LocalPlane(picture.drones().stream()
                .flatMap(drone -> Optional.ofNullable(drone.point()).stream())
                .findFirst()
                .orElse(new Geodetic(0, 0)));
        this.near = new TrackForecast(plane, AHEAD_SECONDS, picture.now());
        this.far = new TrackForecast(plane, CLEAR_SECONDS, picture.now());
        this.lasting = new TrackForecast(plane, LASTING_SECONDS, picture.now());
        this.yielding = new HashMap<>(before);
    }

    List<Track> near(TrackedDrone drone) {
        return nearTracks.computeIfAbsent(drone.id(), id -> ordered(drone, near));
    }

    List<Track> far(TrackedDrone drone) {
        return farTracks.computeIfAbsent(drone.id(), id -> ordered(drone, far));
    }

    List<Track> lasting(TrackedDrone drone) {
        return lastingTracks.computeIfAbsent(drone.id(), id -> ordered(drone, lasting));
    }

    /** Who was told to stand, and does not yet, may do either; who stands does. */
    private List<Track> ordered(TrackedDrone drone, TrackForecast forecast) {
        List<Track> tracks = forecast.of(drone);
        Yielding own = yielding.get(drone.id());
        if (own == null || !own.isOrdered() || drone.isLost()) {
            return tracks;
        }
        if (drone.waits()) {
            List<Track> stands = own.aside() == null ? tracks : aside(drone, own, own.aside(), tracks, forecast);
            return own.mayGo(picture.now()) ? withMission(drone, stands, forecast) : stands;
        }
        List<Track> both = new ArrayList<>(stopping(tracks));
        if (own.isUnheeded(picture.now())) {
            both.addAll(tracks);
        }
        return both;
    }

    private List<Track> withMission(TrackedDrone drone, List<Track> ways, TrackForecast forecast) {
        List<Track> all = new ArrayList<>(ways);
        TrackSample here = here(drone);
        if (here != null) {
            all.add(forecast.mission(drone, here));
        }
        return all;
    }

    /** It goes to where it was told to, unless it is there already, or stands all the same. */
    private List<Track> aside(
            TrackedDrone drone, Yielding own, Command.GoTo to, List<Track> tracks, TrackForecast forecast) {
        TrackSample here = here(drone);
        if (here == null || drone.handling() != Handling.COMMANDED) {
            return tracks;
        }
        TrackSample there =
                new TrackSample(plane.spot(to.point()), to.altitude().meters());
        boolean arrived = here.spot().distanceMeters(there.spot()) < THERE_METERS
                && Math.abs(here.low() - there.low()) < THERE_METERS;
        boolean unheeded = own.shouldMove(picture.now()) && drone.isStill();
        return arrived || unheeded ? tracks : List.of(forecast.onward(drone, here, there));
    }

    /** The same, told now to stand. */
    static List<Track> stopping(List<Track> tracks) {
        return tracks.stream()
                .map(track -> track.stopping(TrackForecast.STRIDES_TO_STAND))
                .toList();
    }

    /** Where that way ends, for as long as one that stands may have to. */
    Track standing(Track way) {
        return lasting.standing(way.samples().get(way.samples().size() - 1));
    }

    /** Whatever they do, they do not meet while anybody looks ahead; a quick look that spares the close one. */
    boolean areFar(TrackedDrone one, TrackedDrone other) {
        return areFar(one, other, CLEAR_SECONDS);
    }

    private boolean areFar(TrackedDrone one, TrackedDrone other, double ahead) {
        TrackSample here = here(one);
        TrackSample there = here(other);
        if (here == null || there == null || one.isLost() || other.isLost()) {
            return false;
        }
        double seconds = ahead + Track.STRIDE_SECONDS;
        double reach = seconds * (fastest(one) + fastest(other))
                + ASIDE_METERS
                + least(one, other).horizontalMeters();
        return here.spot().distanceMeters(there.spot()) > reach;
    }

    private static double fastest(TrackedDrone drone) {
        return Math.max(TrackForecast.pace(drone).cruise(), drone.speed());
    }

    /** It stands where the other one comes by, as long as it may have to stand there. */
    boolean standsInTheWay(TrackedDrone drone, TrackedDrone other) {
        Separation least = least(drone, other);
        return !areFar(drone, other, LASTING_SECONDS)
                && lasting(drone).stream()
                        .anyMatch(mine -> lasting(other).stream().anyMatch(yours -> mine.conflicts(yours, least)));
    }

    /** Null: it is not known where it is. */
    @Nullable
    TrackSample here(TrackedDrone drone) {
        TrackSample known = places.get(drone.id());
        if (known == null) {
            known = near.here(drone);
            if (known != null) {
                places.put(drone.id(), known);
            }
        }
        return known;
    }

    /** What two of them are kept apart by. */
    Separation least(TrackedDrone one, TrackedDrone other) {
        Separation of = isPlannedTogether(one, other) ? planned : unplanned;
        return of.plus(0, VerticalMargin.between(one, other));
    }

    static boolean isPlannedTogether(TrackedDrone one, TrackedDrone other) {
        return one.operation() != null && one.operation().equals(other.operation());
    }

    /** The least of what it is apart from all others on such a way in the next seconds. */
    double clearance(TrackedDrone drone, Track way, Function<TrackedDrone, List<Track>> ways) {
        return clearance(drone, way, ways, CLEAR_SECONDS);
    }

    /** The same for as long as one that stands may have to wait until it comes home by itself. */
    double lastingClearance(TrackedDrone drone, Track way) {
        return clearance(drone, way, this::lasting, LASTING_SECONDS);
    }

    private double clearance(TrackedDrone drone, Track way, Function<TrackedDrone, List<Track>> ways, double seconds) {
        double clearance = Double.POSITIVE_INFINITY;
        for (TrackedDrone other : picture.drones()) {
            if (!other.id().equals(drone.id()) && !areFar(drone, other, seconds)) {
                Separation least = least(drone, other);
                for (Track track : ways.apply(other)) {
                    clearance = Math.min(clearance, way.clearance(track, least));
                }
            }
        }
        return clearance;
    }

    @Nullable
    Yielding yielding(TrackedDrone drone) {
        return yielding.get(drone.id());
    }

    /** It gives way so from now on, and is commanded to. */
    void command(TrackedDrone drone, GiveWay give, double seconds, Command command, String why) {
        put(drone, give, seconds, command instanceof Command.GoTo there ? there : null);
        orders.add(new SeparationOrder(drone.id(), command, why));
        nearTracks.remove(drone.id());
        farTracks.remove(drone.id());
        lastingTracks.remove(drone.id());
    }

    /** It steps aside for the other one. */
    void move(TrackedDrone who, TrackedDrone whom, EvasiveMove step) {
        command(
                who,
                give(whom, GiveWay.Manner.MOVE, step.words()),
                step.seconds(),
                goTo(step.to()),
                who.name() + " " + step.words() + ", to make room for " + whom.name() + ".");
    }

    /** It gives way so from now on, without a command. */
    void put(TrackedDrone drone, GiveWay give) {
        put(drone, give, 0, null);
    }

    private void put(TrackedDrone drone, GiveWay give, double seconds, Command.@Nullable GoTo aside) {
        Yielding before = yielding.get(drone.id());
        Instant until = picture.now().plusMillis(Math.round(1_000 * seconds));
        yielding.put(
                drone.id(), before == null ? Yielding.began(give, until, aside) : before.again(give, until, aside));
    }

    GiveWay give(TrackedDrone to, GiveWay.Manner manner, @Nullable String words) {
        return new GiveWay(to.id(), to.name(), manner, picture.now(), false, words);
    }

    boolean mayGo(TrackedDrone drone, TrackSample there) {
        Command.GoTo go = goTo(there);
        FlightIntent intent = drone.intent();
        return (intent == null || intent.bounds().allow(drone, go))
                && picture.mayGo().test(drone, go);
    }

    Command.GoTo goTo(TrackSample there) {
        return new Command.GoTo(plane.place(there.spot()), new Altitude(there.low(), Altitude.Reference.AMSL));
    }

    SeparationDecision decision() {
        Map<DroneId, List<PossiblePlace>> silent = new HashMap<>();
        picture.drones().stream()
                .filter(TrackedDrone::isLost)
                .forEach(drone -> silent.put(drone.id(), places(near(drone))));
        return new SeparationDecision(yielding, orders, silent);
    }

    private List<PossiblePlace> places(List<Track> tracks) {
        return tracks.stream()
                .map(track -> track.samples().get(0))
                .map(now -> new PossiblePlace(plane.place(now.spot()), (now.low() + now.high()) / 2))
                .distinct()
                .toList();
    }
}
