package org.dronemap.core.command;

import java.util.Locale;
import org.dronemap.core.stored.Stored;

/**
 * Command to a vehicle: set the height above home at which it returns.
 *
 * @param atLeast what is set higher stays: there may be something to fly over
 */
@Stored(as = "SetReturnHeight", names = "meters atLeast")
public record SetReturnHeight(double meters, boolean atLeast) implements Command.Standalone {
    public SetReturnHeight {
        if (!(meters >= 0 && meters <= 500)) {
            throw new IllegalArgumentException("a return height must be 0 to 500 m: " + meters);
        }
    }

    @Override
    public CommandKind kind() {
        return CommandKind.SET_RETURN_HEIGHT;
    }

    @Override
    public String summary() {
        return String.format(Locale.ROOT, "fly home at %.0f m%s", meters, atLeast ? " at least" : "");
    }
}
