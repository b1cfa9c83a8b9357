package org.dronemap.cognitive.operation.follow;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.cognitive.follow.Aim;
import org.dronemap.cognitive.follow.Apart;
import org.dronemap.cognitive.follow.Followed;
import org.dronemap.cognitive.follow.Guidance;
import org.dronemap.cognitive.follow.Limits;
import org.dronemap.cognitive.follow.Motion;
import org.dronemap.cognitive.follow.Others;
import org.dronemap.cognitive.follow.Room;
import org.dronemap.cognitive.follow.Side;
import org.dronemap.cognitive.follow.StandOff;
import org.dronemap.cognitive.follow.TargetFilter;
import org.dronemap.cognitive.follow.Whereabouts;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.Spot;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.operation.Scene;
import org.dronemap.core.zone.Zone;
import org.jspecify.annotations.Nullable;

/** Leads one drone beside the phone, or home. Owned by the conductor's thread. */
final class Lead {
    private static final double LONGEST_AHEAD = 2;
    /** Where nothing is known of the link. */
    private static final double USUAL_DOWNLINK_SECONDS = 0.1;

    private static final double MILLIS = 1_000;

    private final TargetFilter target;
    private final Geodetic near;
    private final Apart apart;
    private final Guidance guidance;
    private final Pursuits pursuits = new Pursuits();
    private @Nullable Guidance homeward;
    private Bounds bounds = new Bounds(List.of(), Room.EVERYWHERE, Double.POSITIVE_INFINITY);

    /** The flyable area and the ceiling that zones leave the drone. */
    private record Bounds(List<Zone> zones, Room room, double ceilingAmslMeters) {}

    /** A target that does not move. */
    private record Standing(LocalPlane plane, Spot spot) implements Followed {
        @Override
        public Motion at(Instant time) {
            return new Motion(spot.eastMeters(), spot.northMeters(), 0, 0, 0);
        }
    }

    /** {@code target} belongs to the follow, and was made with {@code near}. */
    Lead(TargetFilter target, Geodetic near, Apart apart) {
        this.target = target;
        this.near = near;
        this.apart = apart;
        guidance = new Guidance(target);
    }

    /** What it is told, so that it comes to that place beside the phone; empty: nothing. {@code aloft}: all others in the air. */
    Optional<Setpoint> beside(FollowState state, FollowOrder.Place place, Scene scene, List<DroneState> aloft) {
        DroneState drone = ours(state, scene);
        Whereabouts here = drone == null ? null : pursuits.of(drone);
        if (drone == null || here == null || state.stage() != Stage.TRACKING || target.last() == null) {
            guidance.letGo();
            return Optional.empty();
        }
        double home = state.order().chosen().homeAmslMeters();
        StandOff standOff = new StandOff(place.side(), place.distanceMeters(), home + place.heightMeters());
        Bounds within = bounds(state, scene, drone);
        Guidance.Surroundings around = new Guidance.Surroundings(within.room(), others(scene, drone, aloft));
        Aim aim = guidance.lead(scene.now(), standOff, limits(state, drone, within), around, here, scene.sighted());
        return Optional.of(setpoint(aim, Gaze.degrees(target, scene.now(), here, home)));
    }

    /** What it is told on its way home, above all that follow; empty: nothing, it comes home by itself. */
    Optional<Setpoint> home(FollowState state, Scene scene, List<DroneState> aloft) {
        DroneState drone = ours(state, scene);
        Whereabouts here = drone == null ? null : pursuits.of(drone);
        FollowOrder.Chosen chosen = state.order().chosen();
        if (drone == null || here == null || !isLedHome(state, drone, here, scene.now())) {
            homeward = null;
            return Optional.empty();
        }
        if (homeward == null) {
            homeward = new Guidance(new Standing(target.plane(), target.plane().spot(chosen.home())));
        }
        double height = Relay.homewardMeters(state.order().place(), apart);
        StandOff above = new StandOff(new Side.Fixed(0), 0, chosen.homeAmslMeters() + height);
        Bounds within = bounds(state, scene, drone);
        Guidance.Surroundings around = new Guidance.Surroundings(within.room(), others(scene, drone, aloft));
        Aim aim = homeward.lead(scene.now(), above, limits(state, drone, within), around, here, scene.now());
        return Optional.of(setpoint(aim, null));
    }

    private static boolean isLedHome(FollowState state, DroneState drone, Whereabouts here, Instant now) {
        Battery battery = drone.battery();
        boolean guided = drone.capabilities().steering(drone.mode()).orElse(null) == Steering.ORDERS;
        return drone.airborne()
                && Homeward.isLed(
                        state,
                        guided,
                        Geodesy.distanceMeters(
                                here.point(), state.order().chosen().home()),
                        battery == null ? null : battery.percent(),
                        now);
    }

    private static @Nullable DroneState ours(FollowState state, Scene scene) {
        return scene.of(state.drone())
                .filter(seen -> seen.takenBy() == null)
                .map(Scene.Seen::state)
                .orElse(null);
    }

    /** What it is asked for may be as high as zones let it, and nothing else higher. */
    private static Limits limits(FollowState state, DroneState drone, Bounds within) {
        FollowOrder order = state.order();
        double home = order.chosen().homeAmslMeters();
        double asked = home + order.place().heightMeters();
        return new Limits(
                order.speed(),
                home + FollowOrder.LOWEST_METERS,
                Math.min(home + FollowOrder.HIGHEST_METERS, Math.max(asked, within.ceilingAmslMeters())),
                downlink(drone));
    }

    private static Setpoint setpoint(Aim aim, @Nullable Double gazeDegrees) {
        return new Setpoint.Track(
                aim.point(),
                new Altitude(aim.altitudeAmslMeters(), Altitude.Reference.AMSL),
                new Setpoint.Velocity(
                        Setpoint.Frame.EARTH, aim.northward(), aim.eastward(), -aim.upward(), Setpoint.Facing.ANY),
                new Setpoint.Facing.Heading(aim.headingDegrees()),
                gazeDegrees);
    }

    private static double downlink(DroneState drone) {
        Double roundTrip = drone.link().quality().roundTripMillis();
        return roundTrip == null ? USUAL_DOWNLINK_SECONDS : Math.min(2, roundTrip / 2 / MILLIS);
    }

    /** Made anew when the zones are others: what binds the drone may come and go while it follows. */
    private Bounds bounds(FollowState state, Scene scene, DroneState drone) {
        List<Zone> now = scene.around().zones().getOrDefault(drone.id(), List.of());
        if (!now.equals(bounds.zones())) {
            double home = state.order().chosen().homeAmslMeters();
            bounds = new Bounds(now, Fences.room(near, now), Fences.ceilingAmslMeters(now, home));
        }
        return bounds;
    }

    private Others others(Scene scene, DroneState drone, List<DroneState> aloft) {
        List<Others.Heard> all = new ArrayList<>();
        pursuits.of(aloft, drone)
                .forEach((id, one) -> all.add(new Others.Heard(
                        one,
                        Math.max(0, Math.min(LONGEST_AHEAD, seconds(one.at(), scene.now()) + downlink(drone))),
                        scene.around().led().contains(id))));
        return Others.of(target.plane(), all, apart);
    }

    private static double seconds(Instant from, Instant to) {
        return Duration.between(from, to).toMillis() / MILLIS;
    }
}
