package org.dronemap.core.command;

import java.util.List;
import org.dronemap.core.mission.CountText;
import org.dronemap.core.mission.RallyPoint;
import org.dronemap.core.stored.Stored;

/** Command to a vehicle: replace the rally points on board; none at all takes them away. */
@Stored(as = "SetRallyPoints", names = "points")
public record SetRallyPoints(List<RallyPoint> points) implements Command.Standalone {
    public static final int MOST_POINTS = 250;

    public SetRallyPoints {
        points = List.copyOf(points);
        if (points.size() > MOST_POINTS) {
            throw new IllegalArgumentException("there are at most 250 rally points, not " + points.size());
        }
    }

    @Override
    public CommandKind kind() {
        return CommandKind.SET_RALLY_POINTS;
    }

    @Override
    public String summary() {
        return points.isEmpty() ? "take the rally points away" : "set " + CountText.of(points.size(), "rally point");
    }
}
