package org.dronemap.core.command;

import java.util.Locale;
import org.dronemap.core.stored.Stored;

/**
 * Command: go on at that speed, 0.1 to 100 m/s, until the mode changes; air speed for what flies on wings, over the
 * ground for all others. Each kind of vehicle has bounds of its own within these.
 */
@Stored(as = "ChangeSpeed", names = "metersPerSecond")
public record ChangeSpeed(double metersPerSecond) implements Command.Standalone {
    public static final double SLOWEST = 0.1;
    public static final double FASTEST = 100;

    public ChangeSpeed {
        if (!(metersPerSecond >= SLOWEST && metersPerSecond <= FASTEST)) {
            throw new IllegalArgumentException("a speed must be 0.1 to 100 m/s: " + metersPerSecond);
        }
    }

    @Override
    public CommandKind kind() {
        return CommandKind.CHANGE_SPEED;
    }

    @Override
    public String summary() {
        return String.format(Locale.ROOT, "change speed to %.1f m/s", metersPerSecond);
    }
}
