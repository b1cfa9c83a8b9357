package org.dronemap.cognitive.operation.follow;

import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.separation.FlightIntent;
import org.dronemap.core.separation.FlightIntent.Step;

/**
 * Derives from the state of a follow what its drones do next where nobody leads them: who leads them keeps them apart from
 * others by itself.
 */
final class FollowIntents {
    private FollowIntents() {}

    static Map<DroneId, FlightIntent> of(FollowState leader, Instant now) {
        Map<DroneId, FlightIntent> intents = new HashMap<>();
        Stream.concat(
                        Stream.of(leader),
                        leader.reliefOrNone().others().stream()
                                .filter(other ->
                                        !other.wasReplacedBy(leader) || !GuidedReturn.mayBeSteered(other, now)))
                .forEach(one -> put(intents, one));
        return intents;
    }

    private static void put(Map<DroneId, FlightIntent> intents, FollowState one) {
        double height = one.order().place().heightMeters();
        switch (one.stage()) {
            case STARTING -> intents.put(one.drone(), intent(Step.RISE, List.of(new MissionItem.TakeOff(height)), one));
            case RETURNING -> intents.put(one.drone(), intent(Step.COME_HOME, List.of(), one));
            case ALLOCATED, TRACKING, PAUSED, SUSPENDED, OVER -> {}
        }
    }

    private static FlightIntent intent(Step step, List<MissionItem> items, FollowState one) {
        return new FlightIntent(step, items, null, one.issuedCommand() != null, one.since());
    }
}
