package org.dronemap.core.command;

import java.util.Locale;
import org.dronemap.core.stored.Stored;
import org.jspecify.annotations.Nullable;

/**
 * Command to a robot: go to a point in its own frame, such as a building map; metres, each at most 100 km.
 *
 * @param zMeters null for what stays on the ground
 */
@Stored(as = "GoToLocal", names = "xMeters yMeters zMeters")
public record GoToLocal(
        double xMeters, double yMeters, @Nullable Double zMeters) implements Command.Standalone {
    private static final double FARTHEST_METERS = 100_000;

    public GoToLocal {
        boolean near = Math.abs(xMeters) <= FARTHEST_METERS
                && Math.abs(yMeters) <= FARTHEST_METERS
                && (zMeters == null || Math.abs(zMeters) <= FARTHEST_METERS);
        if (!near) {
            throw new IllegalArgumentException(
                    "a place on a map is at most 100 km from its origin: " + xMeters + ", " + yMeters + ", " + zMeters);
        }
    }

    @Override
    public CommandKind kind() {
        return CommandKind.GO_TO_LOCAL;
    }

    @Override
    public String summary() {
        return String.format(Locale.ROOT, "go to %.2f, %.2f m on its own map", xMeters, yMeters);
    }
}
