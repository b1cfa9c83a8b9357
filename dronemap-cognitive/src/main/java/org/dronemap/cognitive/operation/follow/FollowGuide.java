package org.dronemap.cognitive.operation.follow;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronemap.cognitive.follow.Apart;
import org.dronemap.cognitive.follow.PhoneClock;
import org.dronemap.cognitive.follow.PhoneFix;
import org.dronemap.cognitive.follow.TargetFilter;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.operation.Guide;
import org.dronemap.core.operation.Scene;
import org.dronemap.core.operation.Sighting;

/** Knows where the phone is, and has the drones of one follow led there. Owned by the conductor's thread. */
final class FollowGuide implements Guide<FollowState> {
    private final TargetFilter target;
    private final PhoneClock clock = new PhoneClock();
    private final Geodetic near;
    private final Apart apart;
    private final Map<DroneId, Lead> leads = new HashMap<>();

    /** {@code near}: where the phone was when it asked. */
    FollowGuide(Geodetic near, Apart apart) {
        this.near = near;
        this.apart = apart;
        target = new TargetFilter(near);
    }

    @Override
    public boolean sighted(Sighting said) {
        clock.heard(said.sent(), said.heard(), said.roundTrip());
        Sighting.Motion motion = said.motion();
        TargetFilter.Verdict verdict = target.take(new PhoneFix(
                clock.toCloud(said.at()),
                said.point(),
                said.accuracyMeters(),
                motion == null ? null : new PhoneFix.Course(motion.speed(), motion.courseDegrees())));
        return verdict != TargetFilter.Verdict.VAGUE;
    }

    @Override
    public Map<DroneId, Setpoint> steer(FollowState state, Scene scene) {
        FollowOrder.Place place = state.order().place();
        Map<DroneId, Setpoint> said = new HashMap<>();
        lead(state)
                .beside(state, place, scene, aloft(scene, state.drone()))
                .ifPresent(one -> said.put(state.drone(), one));
        for (FollowState other : state.crew().others()) {
            List<DroneState> aloft = aloft(scene, other.drone());
            Optional<Setpoint> one = other.wasReplacedBy(state)
                    ? lead(other).home(other, scene, aloft)
                    : lead(other).beside(other, Relay.standBy(place, apart), scene, aloft);
            one.ifPresent(setpoint -> said.put(other.drone(), setpoint));
        }
        leads.keySet()
                .retainAll(Stream.concat(Stream.of(state), state.crew().others().stream())
                        .map(FollowState::drone)
                        .collect(Collectors.toSet()));
        return said;
    }

    private Lead lead(FollowState one) {
        return leads.computeIfAbsent(one.drone(), drone -> new Lead(target, near, apart));
    }

    /** All but that one; the follow's own are among them. */
    private static List<DroneState> aloft(Scene scene, DroneId but) {
        List<DroneState> all = new ArrayList<>(scene.around().aloft());
        scene.drones().stream()
                .map(Scene.Seen::state)
                .filter(DroneState::airborne)
                .filter(drone -> !drone.id().equals(but))
                .forEach(all::add);
        return all;
    }
}
