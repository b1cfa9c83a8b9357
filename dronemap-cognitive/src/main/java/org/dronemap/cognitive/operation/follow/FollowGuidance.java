package org.dronemap.cognitive.operation.follow;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronemap.cognitive.follow.PhoneClockOffset;
import org.dronemap.cognitive.follow.PhoneFix;
import org.dronemap.cognitive.follow.TargetFilter;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.operation.OperationGuidance;
import org.dronemap.core.operation.OperationObservation;
import org.dronemap.core.operation.TargetReport;
import org.dronemap.core.separation.Separation;

/**
 * Tracks the phone of a follow from its reports, and computes the setpoints for all of the follow's drones. Owned by
 * the conductor's thread.
 */
final class FollowGuidance implements OperationGuidance<FollowState> {
    private final TargetFilter target;
    private final PhoneClockOffset clock = new PhoneClockOffset();
    private final Geodetic near;
    private final Separation apart;
    private final Map<DroneId, FollowDroneGuidance> leads = new HashMap<>();

    /** {@code near}: where the phone was when it asked. */
    FollowGuidance(Geodetic near, Separation apart) {
        this.near = near;
        this.apart = apart;
        target = new TargetFilter(near);
    }

    @Override
    public boolean reported(TargetReport said) {
        clock.messageReceived(said.sentAt(), said.receivedAt(), said.roundTrip());
        TargetReport.Motion motion = said.motion();
        TargetFilter.FixResult verdict = target.update(new PhoneFix(
                clock.toCloud(said.observedAt()),
                said.point(),
                said.accuracyMeters(),
                motion == null ? null : new PhoneFix.Course(motion.speed(), motion.courseDegrees())));
        return verdict != TargetFilter.FixResult.VAGUE;
    }

    @Override
    public Map<DroneId, Setpoint> steer(FollowState state, OperationObservation scene) {
        FollowOrder.RelativePlace place = state.order().place();
        Map<DroneId, Setpoint> said = new HashMap<>();
        steering(state)
                .standOffSetpoint(state, place, scene, aloft(scene, state.drone()))
                .ifPresent(one -> said.put(state.drone(), one));
        for (FollowState other : state.reliefOrNone().others()) {
            List<DroneState> aloft = aloft(scene, other.drone());
            Optional<Setpoint> one = other.wasReplacedBy(state)
                    ? steering(other).returnSetpoint(other, scene, aloft)
                    : steering(other).standOffSetpoint(other, ReliefState.standBy(place, apart), scene, aloft);
            one.ifPresent(setpoint -> said.put(other.drone(), setpoint));
        }
        leads.keySet()
                .retainAll(Stream.concat(Stream.of(state), state.reliefOrNone().others().stream())
                        .map(FollowState::drone)
                        .collect(Collectors.toSet()));
        return said;
    }

    private FollowDroneGuidance steering(FollowState one) {
        return leads.computeIfAbsent(one.drone(), drone -> new FollowDroneGuidance(target, near, apart));
    }

    /** All but that one; the follow's own are among them. */
    private static List<DroneState> aloft(OperationObservation scene, DroneId but) {
        List<DroneState> all = new ArrayList<>(scene.airspace().traffic());
        scene.drones().stream()
                .map(OperationObservation.ObservedDrone::state)
                .filter(DroneState::airborne)
                .filter(drone -> !drone.id().equals(but))
                .forEach(all::add);
        return all;
    }
}
