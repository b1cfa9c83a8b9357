package org.dronemap.cognitive.operation.dispatch;

import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.dronemap.cognitive.operation.dispatch.DispatchLeg.IssuedCommand;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.separation.FlightIntent;
import org.dronemap.core.separation.FlightIntent.Step;

/** Derives from the state of a dispatch what its drones do next, for those who keep all drones apart. */
final class DispatchIntents {
    private DispatchIntents() {}

    static Map<DroneId, FlightIntent> of(DispatchState state) {
        Map<DroneId, FlightIntent> intents = new HashMap<>();
        state.returning()
                .forEach(leg -> intents.put(leg.drone(), intent(Step.COME_HOME, List.of(), leg, state.since())));
        DispatchLeg lead = state.lead();
        if (lead != null && state.stage().leads()) {
            intents.put(lead.drone(), ofLead(state, lead));
        }
        return intents;
    }

    private static FlightIntent ofLead(DispatchState state, DispatchLeg lead) {
        double height = state.order().heightMeters();
        MissionItem there = new MissionItem.Waypoint(state.order().place(), Altitude.aboveHome(height), 0);
        Instant since = state.since();
        return switch (state.stage()) {
            case CHOSEN, STARTING -> intent(Step.RISE, List.of(new MissionItem.TakeOff(height), there), lead, since);
            case EN_ROUTE -> intent(isGoing(lead) ? Step.GO : Step.STAND, List.of(there), lead, since);
            case ARRIVED, HERE, SEARCHING, RETURNING, OVER -> intent(Step.STAND, List.of(there), lead, since);
        };
    }

    private static boolean isGoing(DispatchLeg lead) {
        IssuedCommand issued = lead.issued();
        return lead.going() || (issued != null && issued.purpose() == IssuedCommand.Purpose.GO_TO);
    }

    private static FlightIntent intent(Step step, List<MissionItem> items, DispatchLeg leg, Instant since) {
        return new FlightIntent(step, items, null, leg.issued() != null, since);
    }
}
