package org.dronemap.sim.autopilot.fence;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.sim.flight.SimulatedMissionItem;
import org.dronemap.sim.physics.LocalFrame;
import org.dronemap.sim.physics.NeuPosition;

/** Makes shapes of the items of a fence, with the complaints that ArduPilot has about them. */
final class FenceItems {
    static final int RETURN_POINT = 5000;
    static final int POLYGON_INCLUSION = 5001;
    static final int POLYGON_EXCLUSION = 5002;
    static final int CIRCLE_INCLUSION = 5003;
    static final int CIRCLE_EXCLUSION = 5004;
    private static final int LEAST_CORNERS = 3;

    private final LocalFrame frame;
    private final List<FenceShape> shapes = new ArrayList<>();
    private String complaint = "";

    FenceItems(LocalFrame frame, List<SimulatedMissionItem> items) {
        this.frame = frame;
        int next = 0;
        while (next < items.size() && complaint.isEmpty()) {
            next += read(items, next);
        }
    }

    static boolean isKnown(int command) {
        return command >= RETURN_POINT && command <= CIRCLE_EXCLUSION;
    }

    /** Empty when all is well. */
    String complaint() {
        return complaint;
    }

    List<FenceShape> shapes() {
        return List.copyOf(shapes);
    }

    /** How many items the shape that begins there has. */
    private int read(List<SimulatedMissionItem> items, int first) {
        SimulatedMissionItem item = items.get(first);
        return switch (item.command()) {
            case POLYGON_INCLUSION, POLYGON_EXCLUSION -> readPolygon(items, first);
            case CIRCLE_INCLUSION, CIRCLE_EXCLUSION -> readCircle(item);
            default -> 1;
        };
    }

    private int readCircle(SimulatedMissionItem item) {
        if (!(item.param1() > 0)) {
            complaint = "Non-positive circle radius";
        }
        shapes.add(new FenceShape.Circle(item.command() == CIRCLE_INCLUSION, place(item), item.param1()));
        return 1;
    }

    private int readPolygon(List<SimulatedMissionItem> items, int first) {
        SimulatedMissionItem item = items.get(first);
        int count = (int) item.param1();
        if (count < LEAST_CORNERS) {
            complaint = "Invalid vertex count (" + count + ")";
            return 1;
        }
        List<SimulatedMissionItem> corners = items.subList(first, Math.min(items.size(), first + count));
        if (corners.stream().anyMatch(corner -> corner.command() != item.command())) {
            complaint = "Received incorrect vertex type";
        } else if (corners.size() < count) {
            complaint = "Incorrect item count";
        } else {
            shapes.add(new FenceShape.Polygon(
                    item.command() == POLYGON_INCLUSION,
                    corners.stream().map(this::place).toList()));
        }
        return count;
    }

    private NeuPosition place(SimulatedMissionItem item) {
        return frame.locate(item.x() / 1e7, item.y() / 1e7, 0);
    }
}
