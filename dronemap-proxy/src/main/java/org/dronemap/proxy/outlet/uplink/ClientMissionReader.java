package org.dronemap.proxy.outlet.uplink;

import java.util.List;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.SetFence;
import org.dronemap.core.command.SetRallyPoints;
import org.dronemap.core.drone.OnboardFence;
import org.dronemap.core.drone.OnboardRallyPoints;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.proxy.mavlink.procedure.MavMissionType;
import org.dronemap.proxy.mavlink.translate.FenceCodec;
import org.dronemap.proxy.mavlink.translate.MissionCodec;

/**
 * Reads mission items that a ground station uploads to the outlet as one command, completely or not at all. Stateless.
 */
final class ClientMissionReader {
    private ClientMissionReader() {}

    /** The result of reading a client's items. */
    sealed interface Read {}

    record Understood(Command command) implements Read {}

    record Unsupported(String why) implements Read {}

    /** {@code before}: items in front of a mission that are none of it, as the home that some autopilots keep there. */
    static Read of(int kind, List<MissionItemInt> items, int before) {
        try {
            if (kind == MavMissionType.FENCE.number()) {
                return fence(items);
            }
            return kind == MavMissionType.RALLY.number() ? rally(items) : mission(items, before);
        } catch (IllegalArgumentException e) {
            return new Unsupported("This cannot be put on the vehicle: " + e.getMessage() + ".");
        }
    }

    private static Read mission(List<MissionItemInt> items, int before) {
        if (items.size() <= before) {
            return new Understood(new Command.ClearMission());
        }
        List<MissionItem> mission = MissionCodec.fromWire(items, before);
        for (int index = 0; index < mission.size(); index++) {
            MissionItemInt item = items.get(before + index);
            if (mission.get(index) instanceof MissionItem.Other other) {
                return new Unsupported("Item " + (before + index) + " (" + other.description()
                        + ") is none that the cloud can put on a vehicle.");
            }
            if (MissionCodec.hasMore(item)) {
                return new Unsupported(
                        "Item " + (before + index) + " has settings that the cloud would lose; leave them empty.");
            }
        }
        return new Understood(new Command.UploadMission(new Mission(mission)));
    }

    private static Read fence(List<MissionItemInt> items) {
        OnboardFence fence = FenceCodec.fenceFromWire(items);
        return fence.leftOut().isEmpty()
                ? new Understood(new SetFence(fence.areas(), fence.returnPoint()))
                : new Unsupported(String.join(" ", fence.leftOut()));
    }

    private static Read rally(List<MissionItemInt> items) {
        OnboardRallyPoints rally = FenceCodec.rallyFromWire(items);
        return rally.leftOut().isEmpty()
                ? new Understood(new SetRallyPoints(rally.points()))
                : new Unsupported(String.join(" ", rally.leftOut()));
    }
}
