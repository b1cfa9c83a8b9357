package org.dronemap.cognitive.operation.follow;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import org.dronemap.cognitive.follow.Aim;
import org.dronemap.cognitive.follow.Guidance;
import org.dronemap.cognitive.follow.Limits;
import org.dronemap.cognitive.follow.PhoneClock;
import org.dronemap.cognitive.follow.PhoneFix;
import org.dronemap.cognitive.follow.Room;
import org.dronemap.cognitive.follow.StandOff;
import org.dronemap.cognitive.follow.TargetFilter;
import org.dronemap.cognitive.follow.Whereabouts;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.operation.Guide;
import org.dronemap.core.operation.Scene;
import org.dronemap.core.operation.Sighting;
import org.jspecify.annotations.Nullable;

/** Leads the drone of one follow beside the phone. Owned by the conductor's thread. */
final class FollowGuide implements Guide<FollowState> {
    private static final double MARGIN_METERS = 5;
    /** Where nothing is known of the link. */
    private static final double USUAL_DOWNLINK_SECONDS = 0.1;

    private static final double MILLIS = 1_000;

    private final TargetFilter target;
    private final PhoneClock clock = new PhoneClock();
    private final Guidance guidance;
    private final Room room;
    private @Nullable Whereabouts last;

    FollowGuide(FollowOrder order) {
        target = new TargetFilter(order.near());
        guidance = new Guidance(target);
        room = Room.of(
                order.near(),
                corners(order.fences().stayIn()),
                corners(order.fences().keepOut()),
                MARGIN_METERS);
    }

    private static List<List<Geodetic>> corners(List<FollowOrder.Area> areas) {
        return areas.stream().map(FollowOrder.Area::corners).toList();
    }

    @Override
    public void sighted(Sighting said) {
        clock.heard(said.sent(), said.heard(), said.roundTrip());
        Sighting.Motion motion = said.motion();
        TargetFilter.Verdict unused = target.take(new PhoneFix(
                clock.toCloud(said.at()),
                said.point(),
                said.accuracyMeters(),
                motion == null ? null : new PhoneFix.Course(motion.speed(), motion.courseDegrees())));
    }

    @Override
    public Map<DroneId, Setpoint> steer(FollowState state, Scene scene) {
        DroneState drone = scene.of(state.drone())
                .filter(seen -> seen.takenBy() == null)
                .map(Scene.Seen::state)
                .orElse(null);
        Whereabouts here = drone == null ? null : whereabouts(drone);
        if (drone == null || here == null || state.stage() != Stage.TRACKING || target.last() == null) {
            guidance.letGo();
            return Map.of();
        }
        FollowOrder order = state.order();
        double home = order.chosen().homeAmslMeters();
        Aim aim = guidance.lead(
                scene.now(),
                new StandOff(
                        order.place().side(),
                        order.place().distanceMeters(),
                        home + order.place().heightMeters()),
                new Limits(
                        order.speed(),
                        home + FollowOrder.LOWEST_METERS,
                        home + FollowOrder.HIGHEST_METERS,
                        downlink(drone)),
                room,
                here,
                scene.sighted());
        return Map.of(state.drone(), setpoint(aim));
    }

    private static Setpoint setpoint(Aim aim) {
        return new Setpoint.Track(
                aim.point(),
                new Altitude(aim.altitudeAmslMeters(), Altitude.Reference.AMSL),
                new Setpoint.Velocity(
                        Setpoint.Frame.EARTH, aim.northward(), aim.eastward(), -aim.upward(), Setpoint.Facing.ANY),
                new Setpoint.Facing.Heading(aim.headingDegrees()));
    }

    private static double downlink(DroneState drone) {
        Double roundTrip = drone.link().quality().roundTripMillis();
        return roundTrip == null ? USUAL_DOWNLINK_SECONDS : Math.min(2, roundTrip / 2 / MILLIS);
    }

    /** How it moves is seen from where it was before: what vehicles tell has no direction. */
    private @Nullable Whereabouts whereabouts(DroneState drone) {
        Position position = drone.position();
        Geodetic point = position == null ? null : position.point();
        Double amsl = position == null ? null : position.altitudeAmslMeters();
        if (point == null || amsl == null) {
            return null;
        }
        Whereabouts known = last;
        Instant at = drone.lastUpdate();
        if (known == null || !known.point().equals(point) || known.altitudeAmslMeters() != amsl) {
            last = known == null ? new Whereabouts(at, point, amsl, 0, 0) : known.moved(at, point, amsl);
        }
        return last;
    }
}
