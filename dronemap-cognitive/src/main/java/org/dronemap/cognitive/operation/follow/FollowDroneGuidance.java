package org.dronemap.cognitive.operation.follow;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.cognitive.follow.FlyableArea;
import org.dronemap.cognitive.follow.GuidanceLimits;
import org.dronemap.cognitive.follow.GuidanceSetpoint;
import org.dronemap.cognitive.follow.PlanarMotion;
import org.dronemap.cognitive.follow.StandOff;
import org.dronemap.cognitive.follow.StandOffGuidance;
import org.dronemap.cognitive.follow.StandOffSide;
import org.dronemap.cognitive.follow.TargetFilter;
import org.dronemap.cognitive.follow.TrackedTarget;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.operation.ChosenDrone;
import org.dronemap.core.operation.OperationObservation;
import org.dronemap.core.separation.DroneFix;
import org.dronemap.core.separation.Separation;
import org.dronemap.core.separation.TrafficAvoidance;
import org.dronemap.core.separation.VelocityEstimates;
import org.dronemap.core.zone.Zone;
import org.jspecify.annotations.Nullable;

/**
 * Computes the setpoints for one drone of a follow: beside the phone, or on its way home. Owned by the conductor's
 * thread.
 */
final class FollowDroneGuidance {
    private static final double LONGEST_AHEAD = 2;
    /** Where nothing is known of the link. */
    private static final double USUAL_DOWNLINK_SECONDS = 0.1;

    private static final double MILLIS = 1_000;

    private final TargetFilter target;
    private final Geodetic near;
    private final Separation apart;
    private final StandOffGuidance guidance;
    private final VelocityEstimates pursuits = new VelocityEstimates();
    private @Nullable StandOffGuidance homeward;
    private ZoneBounds bounds = new ZoneBounds(List.of(), FlyableArea.EVERYWHERE, Double.POSITIVE_INFINITY);

    /** The flyable area and the ceiling that zones leave the drone. */
    private record ZoneBounds(List<Zone> zones, FlyableArea room, double ceilingAmslMeters) {}

    /** A target that does not move. */
    private record StationaryTarget(LocalPlane plane, PlanePoint spot) implements TrackedTarget {
        @Override
        public PlanarMotion at(Instant time) {
            return new PlanarMotion(spot.eastMeters(), spot.northMeters(), 0, 0, 0);
        }
    }

    /** {@code target} belongs to the follow, and was made with {@code near}. */
    FollowDroneGuidance(TargetFilter target, Geodetic near, Separation apart) {
        this.target = target;
        this.near = near;
        this.apart = apart;
        guidance = new StandOffGuidance(target);
    }

    /** What it is told, so that it comes to that place beside the phone; empty: nothing. {@code aloft}: all others in the air. */
    Optional<Setpoint> standOffSetpoint(
            FollowState state, FollowOrder.RelativePlace place, OperationObservation scene, List<DroneState> aloft) {
        DroneState drone = droneState(state, scene);
        DroneFix here = drone == null ? null : pursuits.of(drone);
        if (drone == null || here == null || state.stage() != FollowStage.TRACKING || target.last() == null) {
            guidance.reset();
            return Optional.empty();
        }
        double home = state.order().chosen().homeAmslMeters();
        StandOff standOff = new StandOff(place.side(), place.distanceMeters(), home + place.heightMeters());
        ZoneBounds within = bounds(state, scene, drone);
        StandOffGuidance.Environment around =
                new StandOffGuidance.Environment(within.room(), others(scene, drone, aloft));
        GuidanceSetpoint aim =
                guidance.guide(scene.now(), standOff, limits(state, drone, within), around, here, scene.lastReportAt());
        return Optional.of(setpoint(aim, GimbalPitch.degrees(target, scene.now(), here, home)));
    }

    /** What it is told on its way home, above all that follow; empty: nothing, it comes home by itself. */
    Optional<Setpoint> returnSetpoint(FollowState state, OperationObservation scene, List<DroneState> aloft) {
        DroneState drone = droneState(state, scene);
        DroneFix here = drone == null ? null : pursuits.of(drone);
        ChosenDrone chosen = state.order().chosen();
        if (drone == null || here == null || !isSteeredHome(state, drone, here, scene.now())) {
            homeward = null;
            return Optional.empty();
        }
        if (homeward == null) {
            homeward = new StandOffGuidance(
                    new StationaryTarget(target.plane(), target.plane().spot(chosen.home())));
        }
        double height = ReliefState.homewardMeters(state.order().place(), apart);
        StandOff above = new StandOff(new StandOffSide.Fixed(0), 0, chosen.homeAmslMeters() + height);
        ZoneBounds within = bounds(state, scene, drone);
        StandOffGuidance.Environment around =
                new StandOffGuidance.Environment(within.room(), others(scene, drone, aloft));
        GuidanceSetpoint aim =
                homeward.guide(scene.now(), above, limits(state, drone, within), around, here, scene.now());
        return Optional.of(setpoint(aim, null));
    }

    private static boolean isSteeredHome(FollowState state, DroneState drone, DroneFix here, Instant now) {
        Battery battery = drone.battery();
        boolean guided = drone.capabilities().steering(drone.mode()).orElse(null) == Steering.ORDERS;
        return drone.airborne()
                && GuidedReturn.isSteered(
                        state,
                        guided,
                        Geodesy.distanceMeters(
                                here.point(), state.order().chosen().home()),
                        battery == null ? null : battery.percent(),
                        now);
    }

    private static @Nullable DroneState droneState(FollowState state, OperationObservation scene) {
        return scene.of(state.drone())
                .filter(seen -> seen.whyNotCommandable() == null)
                .map(OperationObservation.ObservedDrone::state)
                .orElse(null);
    }

    /** What it is asked for may be as high as zones let it, and nothing else higher. */
    private static GuidanceLimits limits(FollowState state, DroneState drone, ZoneBounds within) {
        FollowOrder order = state.order();
        double home = order.chosen().homeAmslMeters();
        double asked = home + order.place().heightMeters();
        return new GuidanceLimits(
                order.speed(),
                home + FollowOrder.LOWEST_METERS,
                Math.min(home + FollowOrder.HIGHEST_METERS, Math.max(asked, within.ceilingAmslMeters())),
                downlink(drone));
    }

    private static Setpoint setpoint(GuidanceSetpoint aim, @Nullable Double cameraElevationDegrees) {
        return new Setpoint.Track(
                aim.point(),
                new Altitude(aim.altitudeAmslMeters(), Altitude.Reference.AMSL),
                new Setpoint.Velocity(
                        Setpoint.Frame.EARTH, aim.northward(), aim.eastward(), -aim.upward(), Setpoint.Facing.ANY),
                new Setpoint.Facing.Heading(aim.headingDegrees()),
                cameraElevationDegrees);
    }

    private static double downlink(DroneState drone) {
        Double roundTrip = drone.link().quality().roundTripMillis();
        return roundTrip == null ? USUAL_DOWNLINK_SECONDS : Math.min(2, roundTrip / 2 / MILLIS);
    }

    /** Made anew when the zones are others: what binds the drone may come and go while it follows. */
    private ZoneBounds bounds(FollowState state, OperationObservation scene, DroneState drone) {
        List<Zone> now = scene.airspace().zones().getOrDefault(drone.id(), List.of());
        if (!now.equals(bounds.zones())) {
            double home = state.order().chosen().homeAmslMeters();
            bounds = new ZoneBounds(
                    now, FollowZoneLimits.room(near, now), FollowZoneLimits.ceilingAmslMeters(now, home));
        }
        return bounds;
    }

    private TrafficAvoidance others(OperationObservation scene, DroneState drone, List<DroneState> aloft) {
        List<TrafficAvoidance.ReportedDrone> all = new ArrayList<>();
        pursuits.of(aloft, drone)
                .forEach((id, one) -> all.add(new TrafficAvoidance.ReportedDrone(
                        one,
                        Math.max(0, Math.min(LONGEST_AHEAD, seconds(one.at(), scene.now()) + downlink(drone))),
                        scene.airspace().steered().contains(id))));
        scene.airspace()
                .silent()
                .forEach(place -> all.add(new TrafficAvoidance.ReportedDrone(
                        new DroneFix(scene.now(), place.point(), place.altitudeAmslMeters(), 0, 0), 0, false)));
        return TrafficAvoidance.of(target.plane(), all, apart);
    }

    private static double seconds(Instant from, Instant to) {
        return Duration.between(from, to).toMillis() / MILLIS;
    }
}
