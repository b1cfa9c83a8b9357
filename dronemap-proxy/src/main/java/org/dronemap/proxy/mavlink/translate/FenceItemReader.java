package org.dronemap.proxy.mavlink.translate;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dronemap.core.drone.OnboardFence;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.mission.FenceReturnPoint;
import org.dronemap.core.mission.HeightReference;
import org.dronemap.mavlink.message.MissionItemInt;
import org.jspecify.annotations.Nullable;

/**
 * Reads the MAVLink items of one fence, as ArduPilot checks them: each corner says of how many corners its area is. What
 * cannot be told is named, never passed over. Used once, by one thread.
 */
final class FenceItemReader {
    private final List<MissionItemInt> items;
    private final List<FenceArea> areas = new ArrayList<>();
    private final List<String> leftOut = new ArrayList<>();
    private @Nullable FenceReturnPoint returnPoint;

    private FenceItemReader(List<MissionItemInt> items) {
        this.items = items;
    }

    static OnboardFence read(List<MissionItemInt> items) {
        FenceItemReader reader = new FenceItemReader(items);
        int next = 0;
        while (next < items.size()) {
            next = reader.part(next);
        }
        return new OnboardFence(reader.areas, reader.returnPoint, reader.leftOut);
    }

    /** Reads what begins there; where the next part begins. */
    private int part(int first) {
        MissionItemInt item = items.get(first);
        switch (item.command()) {
            case FenceCodec.POLYGON_INSIDE, FenceCodec.POLYGON_OUTSIDE -> {
                return polygon(first);
            }
            case FenceCodec.CIRCLE_INSIDE, FenceCodec.CIRCLE_OUTSIDE -> circle(first, item);
            case FenceCodec.RETURN_POINT -> returnPoint(first, item);
            default ->
                leftOut.add(String.format(
                        Locale.ROOT, "Item %d (command %d) is no part of a fence.", first + 1, item.command()));
        }
        return first + 1;
    }

    private int polygon(int first) {
        MissionItemInt begin = items.get(first);
        int wanted = Math.round(begin.param1());
        int end = first;
        while (end < items.size()
                && (end - first < wanted || end == first)
                && items.get(end).command() == begin.command()
                && Math.round(items.get(end).param1()) == wanted) {
            end++;
        }
        Optional<String> fault = fault(first, end, wanted);
        if (fault.isPresent()) {
            leftOut.add(fault.get());
        } else {
            areas.add(new FenceArea.Polygon(
                    begin.command() == FenceCodec.POLYGON_INSIDE,
                    items.subList(first, end).stream().map(FenceCodec::point).toList()));
        }
        return end;
    }

    private Optional<String> fault(int first, int end, int wanted) {
        String where = words(first, end, items.get(first).command());
        if (wanted < FenceArea.Polygon.LEAST_CORNERS || wanted > FenceArea.Polygon.MOST_CORNERS) {
            return Optional.of(where + " should have " + wanted + " corners; an area has "
                    + FenceArea.Polygon.LEAST_CORNERS + " to " + FenceArea.Polygon.MOST_CORNERS + ".");
        }
        if (end - first != wanted) {
            return Optional.of(
                    where + " should have " + wanted + " corners, and there are " + (end - first) + " in a row.");
        }
        for (int index = first; index < end; index++) {
            if (!FenceCodec.isPlace(items.get(index))) {
                return Optional.of(where + " has a corner that is no place, " + place(items.get(index)) + ".");
            }
        }
        return Optional.empty();
    }

    private void circle(int at, MissionItemInt item) {
        String where = words(at, at + 1, item.command());
        double radius = FenceCodec.exact(item.param1());
        if (!FenceCodec.isPlace(item)) {
            leftOut.add(where + " is round no place, " + place(item) + ".");
        } else if (radius >= FenceArea.Circle.LEAST_RADIUS_METERS && radius <= FenceArea.Circle.MOST_RADIUS_METERS) {
            areas.add(new FenceArea.Circle(item.command() == FenceCodec.CIRCLE_INSIDE, FenceCodec.point(item), radius));
        } else {
            leftOut.add(where + " has a radius of " + radius + " m; a circle has 0.01 to 100000 m.");
        }
    }

    private void returnPoint(int at, MissionItemInt item) {
        Optional<HeightReference> reference = FenceCodec.reference(item.frame());
        String where = words(at, at + 1, item.command());
        if (returnPoint != null) {
            leftOut.add(where + " is a second one; a fence has one.");
        } else if (!FenceCodec.isPlace(item)) {
            leftOut.add(where + " is no place, " + place(item) + ".");
        } else if (reference.isEmpty() || !FenceCodec.isHeight(item.z())) {
            leftOut.add(where + " has a height of " + FenceCodec.exact(item.z()) + " m in frame " + item.frame()
                    + ", which cannot be told.");
        } else {
            returnPoint = new FenceReturnPoint(FenceCodec.point(item), FenceCodec.exact(item.z()), reference.get());
        }
    }

    /** Counted from 1, as people do. */
    private static String words(int first, int end, int command) {
        String what = switch (command) {
            case FenceCodec.POLYGON_INSIDE -> "an area to stay in";
            case FenceCodec.POLYGON_OUTSIDE -> "an area to stay out of";
            case FenceCodec.CIRCLE_INSIDE -> "a circle to stay in";
            case FenceCodec.CIRCLE_OUTSIDE -> "a circle to stay out of";
            default -> "the return point";
        };
        String which = end - first == 1 ? "Item " + (first + 1) : "Items " + (first + 1) + " to " + end;
        return which + " (" + what + ")";
    }

    private static String place(MissionItemInt item) {
        return String.format(Locale.ROOT, "%.7f, %.7f", item.x() / FenceCodec.E7, item.y() / FenceCodec.E7);
    }
}
