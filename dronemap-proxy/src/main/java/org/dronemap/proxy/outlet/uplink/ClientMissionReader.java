package org.dronemap.proxy.outlet.uplink;

import java.util.List;
import java.util.Optional;
import org.dronemap.core.command.Command;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.mission.RallyPoint;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.proxy.mavlink.procedure.MavMissionType;
import org.dronemap.proxy.mavlink.translate.AutopilotAdapter;
import org.dronemap.proxy.mavlink.translate.FenceCodec;
import org.dronemap.proxy.mavlink.translate.MissionCodec;
import org.jspecify.annotations.Nullable;

/**
 * Reads mission items that a ground station uploads to the outlet as one command, completely or not at all. Stateless.
 */
final class ClientMissionReader {
    private ClientMissionReader() {}

    /** The result of reading a client's items. */
    sealed interface Read {}

    record Understood(Command command) implements Read {}

    record Unsupported(String why) implements Read {}

    /** {@code autopilot}: of the vehicle that gets it; null when that is not known yet. */
    static Read of(int kind, List<MissionItemInt> items, @Nullable AutopilotAdapter autopilot) {
        try {
            if (kind == MavMissionType.FENCE.number()) {
                return fence(items);
            }
            return kind == MavMissionType.RALLY.number() ? rally(items) : mission(items, autopilot);
        } catch (IllegalArgumentException e) {
            return new Unsupported("This cannot be put on the vehicle: " + e.getMessage() + ".");
        }
    }

    private static Read mission(List<MissionItemInt> items, @Nullable AutopilotAdapter autopilot) {
        if (autopilot == null) {
            return new Unsupported("It is not known yet what this vehicle takes; try again in a moment.");
        }
        int before = autopilot.itemsBeforeMission();
        if (items.size() <= before) {
            return new Understood(new Command.ClearMission());
        }
        List<MissionItem> mission = MissionCodec.fromWire(items, before);
        for (int index = 0; index < mission.size(); index++) {
            if (mission.get(index) instanceof MissionItem.Other other) {
                return new Unsupported("Item " + (before + index) + " (" + other.description()
                        + ") is none that the cloud can put on a vehicle.");
            }
            Optional<String> loss = autopilot.missionItemLoss(items.get(before + index));
            if (loss.isPresent()) {
                return new Unsupported("Item " + (before + index) + " " + loss.get());
            }
        }
        return new Understood(new Command.UploadMission(new Mission(mission)));
    }

    private static Read fence(List<MissionItemInt> items) {
        List<FenceArea> zones = FenceCodec.fenceFromWire(items);
        int read = zones.stream()
                .mapToInt(zone -> zone instanceof FenceArea.Polygon polygon
                        ? polygon.corners().size()
                        : 1)
                .sum();
        return read == items.size()
                ? new Understood(new Command.SetFence(zones))
                : new Unsupported(
                        "A fence is of areas with 3 to 100 corners and of circles; there is something else in it.");
    }

    private static Read rally(List<MissionItemInt> items) {
        List<RallyPoint> points = FenceCodec.rallyFromWire(items);
        return points.size() == items.size()
                ? new Understood(new Command.SetRallyPoints(points))
                : new Unsupported("There is something else among the rally points.");
    }
}
