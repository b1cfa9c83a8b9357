package org.dronemap.cognitive.operation.run;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import org.dronemap.cognitive.operation.run.model.DroneObservation;
import org.dronemap.cognitive.operation.run.model.RunDrone;
import org.dronemap.cognitive.operation.run.model.RunDroneStage;
import org.dronemap.cognitive.operation.run.model.Sortie;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.Speeds;
import org.dronemap.core.drone.ReturnHeight;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.safety.SafetyTimes;
import org.jspecify.annotations.Nullable;

/** Forecasts the trajectories of a mission run's drones over the next seconds, to find conflicts between them. */
final class TrajectoryForecast {
    static final double STRIDE_SECONDS = 0.5;
    /** Vehicles that were told no other height climb to this before they fly home, in m over it. */
    private static final double RETURN_METERS = 15;
    /** From when it was heard last until its fail-safe acts: of firmware whose time cannot be set, and of all others. */
    private static final List<Double> UNTIL_HOMEWARD_SECONDS =
            List.of(6.0, SafetyTimes.VEHICLE_RETURNS.toSeconds() + 1.0);
    /** Beyond that an order may not have arrived. */
    private static final Duration UNTIL_OBEYED = Duration.ofMillis(1_500);

    /** What it may be ahead, as a share of the time since: it may climb and sink quicker than planned with. */
    private static final double FASTER = 0.1;
    /** What it may be behind. */
    private static final double SLOWER = 0.2;
    /** Between two places where it may be by now: others have no room between them. */
    private static final double STEP_METERS = 12;

    private static final double MOST_STEPS = 40;
    /** As a share of the least distance: by so much less two who leave each other may be apart at first. */
    static final double LEAVING = 0.02;

    private final LocalPlane plane;
    private final int strides;

    TrajectoryForecast(LocalPlane plane, double seconds) {
        this.plane = plane;
        this.strides = (int) Math.ceil(seconds / STRIDE_SECONDS);
    }

    /** A place at one time step, with the range of heights possible there. */
    record Sample(PlanePoint spot, double low, double high) {
        Sample(PlanePoint spot, double meters) {
            this(spot, meters, meters);
        }

        private boolean isStacked(Sample other, double vertical) {
            return low - other.high >= vertical || other.low - high >= vertical;
        }
    }

    /** One place for each stride, from now on. */
    record Trajectory(List<Sample> places) {
        Trajectory {
            places = List.copyOf(places);
        }

        /** As if it stopped after so many strides. */
        Trajectory stopping(int after) {
            List<Sample> stands = new ArrayList<>();
            for (int i = 0; i < places.size(); i++) {
                stands.add(places.get(Math.min(i, after)));
            }
            return new Trajectory(stands);
        }

        /** The least distance, as a share of the one that is asked for: from 1 on they are apart. */
        double clearance(Trajectory other, double horizontal, double vertical) {
            double least = Double.POSITIVE_INFINITY;
            for (int i = 0; i < Math.min(places.size(), other.places().size()); i++) {
                Sample here = places.get(i);
                Sample there = other.places().get(i);
                double stacked = Math.max(here.low - there.high, there.low - here.high) / vertical;
                double beside = here.spot().distanceMeters(there.spot()) / horizontal;
                least = Math.min(least, Math.max(stacked, beside));
            }
            return least;
        }

        /** As if it set off so many strides later. */
        Trajectory after(int strides) {
            List<Sample> later = new ArrayList<>();
            for (int i = 0; i < places.size(); i++) {
                later.add(places.get(Math.max(0, i - strides)));
            }
            return new Trajectory(later);
        }

        /** Never nearer than now, and apart in the end: that is over the sooner the less either of them is stopped. */
        boolean leaves(Trajectory other, double horizontal, double vertical) {
            int last = Math.min(places.size(), other.places().size()) - 1;
            double now = clearance(new Trajectory(other.places().subList(0, 1)), horizontal, vertical);
            double end = new Trajectory(places.subList(last, last + 1))
                    .clearance(new Trajectory(other.places().subList(last, last + 1)), horizontal, vertical);
            return end >= 1 && clearance(other, horizontal, vertical) >= now - LEAVING;
        }

        boolean meets(Trajectory other, double horizontal, double vertical) {
            for (int i = 0; i < Math.min(places.size(), other.places().size()); i++) {
                Sample here = places.get(i);
                Sample there = other.places().get(i);
                if (!here.isStacked(there, vertical) && here.spot().distanceMeters(there.spot()) < horizontal) {
                    return true;
                }
            }
            return false;
        }
    }

    /** The same, told now to stand. */
    static List<Trajectory> stopping(List<Trajectory> tracks) {
        return tracks.stream()
                .map(track -> track.stopping(SeparationGuard.STRIDES_TO_STAND))
                .toList();
    }

    /** What it may do; none where it is on the ground, or nobody knows where it is. */
    List<Trajectory> of(RunTransition draft, RunDrone drone, @Nullable DroneObservation look) {
        RunDrone.LinkLoss silence = drone.flags().linkLoss();
        if (drone.stage() == RunDroneStage.SILENT && silence != null && silence.place() != null) {
            double gone = Duration.between(silence.lastContact(), draft.now()).toMillis() / 1_000.0;
            return corridor(drone, silence.place(), gone);
        }
        Place place = look == null ? null : look.place();
        if (place == null || look == null || !look.airborne() || isDownSomewhere(drone, look)) {
            return List.of();
        }
        boolean late = isLate(draft, drone);
        return switch (drone.stage()) {
            case STARTING, FLYING -> List.of(flying(drone, look, place));
            case CONTINUING ->
                late && look.waits()
                        ? List.of(mission(drone, place), new Trajectory(standing(place)))
                        : List.of(mission(drone, place));
            case HOLDING -> holding(drone, look, place, late);
            case RETURNING -> returning(drone, look, place);
            case CRASHED -> FlightHealth.isSeenToFly(drone, look) ? byItself(drone, look, place) : List.of();
            default -> byItself(drone, look, place);
        };
    }

    /** Where it was heard last, in the air, is not where it is. */
    private static boolean isDownSomewhere(RunDrone drone, DroneObservation look) {
        return drone.stage() == RunDroneStage.GONE && !look.isLive();
    }

    /** Its order should have shown by now: it may be lost. */
    private static boolean isLate(RunTransition draft, RunDrone drone) {
        RunDrone.IssuedCommand errand = drone.issuedCommand();
        return errand == null
                ? drone.attempts().failed() > 0
                : Duration.between(errand.at(), draft.now()).compareTo(UNTIL_OBEYED) > 0;
    }

    private List<Trajectory> holding(RunDrone drone, DroneObservation look, Place place, boolean late) {
        if (!look.isOnMission()) {
            return List.of(new Trajectory(standing(place)));
        }
        Trajectory flies = flying(drone, look, place);
        Trajectory stops = flies.stopping(SeparationGuard.STRIDES_TO_STAND);
        return late ? List.of(stops, flies) : List.of(stops);
    }

    private List<Trajectory> returning(RunDrone drone, DroneObservation look, Place place) {
        if (!look.waits()) {
            return List.of(homeward(drone, place));
        }
        boolean called =
                drone.issuedCommand() != null && drone.issuedCommand().kind() == RunDrone.IssuedCommand.Purpose.HOME;
        Trajectory stands = new Trajectory(standing(place));
        return called ? List.of(stands, homeward(drone, place)) : List.of(stands);
    }

    private List<Trajectory> byItself(RunDrone drone, DroneObservation look, Place place) {
        return List.of(
                look.comesDown()
                        ? homeward(drone, at(place), 0)
                        : look.isOnMission() ? flying(drone, look, place) : new Trajectory(standing(place)));
    }

    /** Where a drone that is not heard may be: on its mission, sooner or later, or on its way home from where it missed us. */
    private List<Trajectory> corridor(RunDrone drone, Place from, double gone) {
        double cruise = drone.craft().performance().speeds().cruise();
        List<Trajectory> ways = new ArrayList<>();
        double doubt = gone * (FASTER + SLOWER) * cruise;
        int steps = (int) Math.max(1, Math.min(MOST_STEPS, Math.ceil(doubt / STEP_METERS)));
        for (int step = 0; step <= steps; step++) {
            ways.add(mission(drone, from, gone * (1 + FASTER - (FASTER + SLOWER) * step / steps), cruise));
        }
        ways.add(homeward(drone, at(from), gone));
        for (double until : UNTIL_HOMEWARD_SECONDS) {
            Sample missing =
                    mission(drone, from, Math.min(gone, until), cruise).places().get(0);
            ways.add(homeward(drone, missing, Math.max(0, gone - until)));
        }
        return ways;
    }

    /** It comes to stand first, and goes there then. */
    Trajectory dodging(RunDrone drone, Place from, Place to) {
        Trajectory first = drone.stage() == RunDroneStage.FLYING
                ? mission(drone, from, 0, drone.craft().performance().speeds().cruise())
                        .stopping(SeparationGuard.STRIDES_TO_STAND)
                : new Trajectory(standing(from));
        List<Sample> places = new ArrayList<>(first.places().subList(0, SeparationGuard.STRIDES_TO_STAND));
        Sample stands = places.get(places.size() - 1);
        TrajectoryBuilder walk =
                new TrajectoryBuilder(drone.craft().performance().speeds(), stands, 0, 0);
        Sample there = at(to);
        walk.to(there);
        places.addAll(walk.track().places());
        return new Trajectory(places.subList(0, strides + 1));
    }

    private Trajectory flying(RunDrone drone, DroneObservation look, Place place) {
        Double speed = look.speed();
        return mission(drone, place, 0, look.isOnMission() && speed != null ? speed : 0);
    }

    /** It sets off from a stand. */
    Trajectory mission(RunDrone drone, Place from) {
        return mission(drone, from, 0, 0);
    }

    /** {@code moving}: how fast it was there, that long ago. */
    private Trajectory mission(RunDrone drone, Place from, double ago, double moving) {
        TrajectoryBuilder walk =
                new TrajectoryBuilder(drone.craft().performance().speeds(), at(from), ago, moving);
        Sortie sortie = drone.sortie();
        if (sortie != null) {
            List<MissionItem> items = sortie.mission().items();
            for (MissionItem item : items.subList(Math.min(drone.passed(), items.size()), items.size())) {
                go(walk, item, drone.craft().homeAmslMeters());
            }
        }
        return walk.track();
    }

    private void go(TrajectoryBuilder walk, MissionItem item, double homeAmslMeters) {
        switch (item.kind()) {
            case WAYPOINT -> {
                MissionItem.Waypoint waypoint = (MissionItem.Waypoint) item;
                walk.to(at(MissionLegs.place(waypoint)));
                walk.waitFor(waypoint.holdSeconds());
            }
            case TAKE_OFF -> {
                double top = homeAmslMeters + ((MissionItem.TakeOff) item).altitudeMeters();
                walk.to(new Sample(walk.last().spot(), top));
            }
            case WAIT -> walk.waitFor(((MissionItem.Wait) item).seconds());
            case RETURN_TO_LAUNCH, LAND, OTHER -> walk.down(homeAmslMeters);
            case TAKE_PHOTO, SET_SERVO, LOOK_AT, LOOK_AHEAD -> {}
        }
    }

    Trajectory homeward(RunDrone drone, Place from) {
        return homeward(drone, at(from), 0);
    }

    private Trajectory homeward(RunDrone drone, Sample from, double ago) {
        Place home = drone.craft().finish().place();
        TrajectoryBuilder walk =
                new TrajectoryBuilder(drone.craft().performance().speeds(), from, ago, 0);
        ReturnHeight set = drone.flags().returnHeight();
        double height = Math.max(from.high(), home.altitudeAmslMeters() + (set == null ? RETURN_METERS : set.meters()));
        boolean there = from.spot().distanceMeters(at(home).spot()) < 2;
        if (!there) {
            walk.to(new Sample(from.spot(), height));
            walk.to(new Sample(at(home).spot(), height));
        }
        walk.down(home.altitudeAmslMeters());
        return walk.track();
    }

    private List<Sample> standing(Place place) {
        List<Sample> places = new ArrayList<>();
        for (int i = 0; i <= strides; i++) {
            places.add(at(place));
        }
        return places;
    }

    private Sample at(Place place) {
        return new Sample(plane.spot(place.point()), place.altitudeAmslMeters());
    }

    /** Goes from place to place and notes where it is at each stride. */
    private final class TrajectoryBuilder {
        private final Speeds speeds;
        private final List<Sample> places = new ArrayList<>();
        private final double ago;
        private Sample here;
        private double moving;
        private double seconds;

        TrajectoryBuilder(Speeds speeds, Sample from, double ago, double moving) {
            this.speeds = speeds;
            this.here = from;
            this.ago = ago;
            this.moving = moving;
            note(from, 0, share -> share);
        }

        Sample last() {
            return here;
        }

        void to(Sample there) {
            double meters = here.spot().distanceMeters(there.spot());
            double climb = there.low() - here.low();
            double vertical = climb > 0 ? climb / speeds.climb() : -climb / speeds.descent();
            MotionProfile dash = new MotionProfile(meters, moving, speeds);
            moving = 0;
            if (dash.seconds() > vertical) {
                go(there, dash.seconds(), share -> dash.share(share * dash.seconds()));
            } else {
                go(there, vertical, share -> share);
            }
        }

        void down(double ground) {
            go(new Sample(here.spot(), ground), Math.max(0, here.low() - ground) / speeds.descent(), share -> share);
        }

        void waitFor(double holdSeconds) {
            go(here, holdSeconds, share -> share);
        }

        private void go(Sample there, double takes, DoubleUnaryOperator way) {
            note(there, takes, way);
            here = there;
            seconds += takes;
        }

        /** What lies before now is passed over; {@code way}: what share of it is behind the drone by that share of the time. */
        private void note(Sample there, double takes, DoubleUnaryOperator way) {
            while (places.size() <= strides && ago + places.size() * STRIDE_SECONDS <= seconds + takes) {
                double share = takes == 0 ? 1 : (ago + places.size() * STRIDE_SECONDS - seconds) / takes;
                places.add(between(here, there, way.applyAsDouble(share)));
            }
        }

        private Sample between(Sample from, Sample there, double share) {
            double east = there.spot().eastMeters() - from.spot().eastMeters();
            double north = there.spot().northMeters() - from.spot().northMeters();
            PlanePoint spot = new PlanePoint(
                    from.spot().eastMeters() + share * east, from.spot().northMeters() + share * north);
            boolean straightUp = Math.hypot(east, north) < 1;
            return straightUp
                    ? new Sample(spot, from.low() + share * (there.low() - from.low()))
                    : new Sample(spot, Math.min(from.low(), there.low()), Math.max(from.low(), there.low()));
        }

        Trajectory track() {
            while (places.size() <= strides) {
                places.add(here);
            }
            return new Trajectory(places);
        }
    }
}
