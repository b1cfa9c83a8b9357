package org.dronemap.core.command;

import java.util.List;
import org.dronemap.core.mission.CountText;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.mission.FenceReturnPoint;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/** Command to a vehicle: replace the fence on board; none at all takes it away. */
@Stored(as = "SetFence", names = "zones returnPoint", later = "returnPoint")
public record SetFence(List<FenceArea> zones, @Nullable FenceReturnPoint returnPoint) implements Command.Standalone {
    public static final int MOST_PARTS = 500;
    /** Corners and circles; more is not read back from a vehicle. */
    public static final int MOST_ITEMS = 2_000;

    public SetFence(List<FenceArea> zones) {
        this(zones, null);
    }

    public SetFence {
        zones = List.copyOf(zones);
        if (zones.size() > MOST_PARTS) {
            throw new IllegalArgumentException("a fence has at most 500 parts, not " + zones.size());
        }
        int items = items(zones) + (returnPoint == null ? 0 : 1);
        if (items > MOST_ITEMS) {
            throw new IllegalArgumentException("a fence has at most 2000 corners and circles, not " + items);
        }
    }

    /** How many corners and circles these are. */
    public static int items(List<FenceArea> zones) {
        return zones.stream()
                .mapToInt(zone -> zone instanceof FenceArea.Polygon polygon
                        ? polygon.corners().size()
                        : 1)
                .sum();
    }

    @Override
    public CommandKind kind() {
        return CommandKind.SET_FENCE;
    }

    @Override
    public String summary() {
        if (returnPoint != null) {
            return "set a fence of " + CountText.of(zones.size(), "part") + " and a return point";
        }
        return zones.isEmpty() ? "take the fence away" : "set a fence of " + CountText.of(zones.size(), "part");
    }
}
