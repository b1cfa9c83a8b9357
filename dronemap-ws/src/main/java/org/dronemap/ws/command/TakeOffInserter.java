package org.dronemap.ws.command;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ValueProblem;

/** Puts a take-off to the first waypoint's altitude in front of a mission that has none, for vehicles that take off. */
final class TakeOffInserter {
    private TakeOffInserter() {}

    static Mission complete(Mission mission, DroneState drone) {
        boolean hasOne = mission.items().stream().anyMatch(MissionItem.TakeOff.class::isInstance);
        Optional<MissionItem.Waypoint> first = mission.items().stream()
                .filter(MissionItem.Waypoint.class::isInstance)
                .map(MissionItem.Waypoint.class::cast)
                .findFirst();
        if (hasOne || first.isEmpty() || !drone.capabilities().commands().contains(Capability.TAKE_OFF)) {
            return mission;
        }
        if (mission.items().size() == Mission.MAX_ITEMS) {
            throw new InvalidInput(
                    ValueProblem.MISSION_UNUSABLE,
                    "items",
                    "1 to " + (Mission.MAX_ITEMS - 1) + " items without a take-off",
                    "A take-off has to go in front of this mission, and then it would have more than "
                            + Mission.MAX_ITEMS + " items.");
        }
        List<MissionItem> items = new ArrayList<>();
        items.add(new MissionItem.TakeOff(heightAboveHome(first.get().altitude(), drone)));
        items.addAll(mission.items());
        return new Mission(items);
    }

    private static double heightAboveHome(Altitude altitude, DroneState drone) {
        double height = altitude.meters();
        if (altitude.reference() == Altitude.Reference.AMSL) {
            Home home = drone.home();
            if (home == null) {
                throw new InvalidInput(
                        ValueProblem.MISSION_UNUSABLE,
                        "items[0]",
                        "a take-off item",
                        "The first waypoint's altitude is above sea level and the drone's home is not known yet, so"
                                + " no take-off height can be worked out; put a take-off item first.");
            }
            height -= home.altitudeAmslMeters();
        }
        return Math.min(500, Math.max(1, height));
    }
}
