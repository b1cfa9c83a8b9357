package org.dronemap.ws.fence;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.command.SetFence;
import org.dronemap.core.command.SetRallyPoints;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.mission.FenceReturnPoint;
import org.dronemap.core.mission.HeightReference;
import org.dronemap.core.mission.RallyPoint;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.FieldRanges;
import org.jspecify.annotations.Nullable;

/** Turns a geofence or rally points that a client wrote into those for a vehicle, or rejects the faulty field. */
final class FenceReader {
    private static final String CORNERS =
            FenceArea.Polygon.LEAST_CORNERS + " to " + FenceArea.Polygon.MOST_CORNERS + " corners";

    private FenceReader() {}

    static SetFence fence(FenceView written) {
        whole(written.leftOut());
        List<FenceView.ZoneView> zones = counted("zones", written.zones(), SetFence.MOST_PARTS, "zones");
        List<FenceArea> read = new ArrayList<>();
        for (int index = 0; index < zones.size(); index++) {
            if (zones.get(index) == null) {
                throw InvalidInput.missing("zones[" + index + "]", "a polygon or a circle");
            }
            read.add(zones.get(index).read("zones[" + index + "]."));
        }
        FenceView.ReturnPointView back = written.returnPoint();
        int items = SetFence.items(read) + (back == null ? 0 : 1);
        if (items > SetFence.MOST_ITEMS) {
            throw InvalidInput.outside(
                    ValueProblem.SIZE_OUT_OF_RANGE,
                    "zones",
                    "at most " + SetFence.MOST_ITEMS + " corners and circles together",
                    items,
                    ProblemParameter.MOST.is(SetFence.MOST_ITEMS));
        }
        return new SetFence(read, back == null ? null : returnPoint(back));
    }

    private static FenceReturnPoint returnPoint(FenceView.ReturnPointView written) {
        Geodetic point = FieldRanges.point("returnPoint.", written.latitude(), written.longitude());
        return written.altitude() == null
                ? FenceReturnPoint.of(point)
                : new FenceReturnPoint(
                        point,
                        FieldRanges.altitude("returnPoint.altitude", written.altitude()),
                        reference("returnPoint.altitudeReference", written.altitudeReference()));
    }

    /** What was read only in part would replace the whole. */
    private static void whole(@Nullable List<String> leftOut) {
        if (leftOut != null && !leftOut.isEmpty()) {
            throw new InvalidInput(
                    ValueProblem.VALUE_NOT_ALLOWED,
                    "leftOut",
                    "empty",
                    "The vehicle has more than what is written here, and would lose it: " + leftOut.get(0)
                            + " Leave \"leftOut\" away if that is meant.");
        }
    }

    private static <T> List<T> counted(String field, @Nullable List<T> written, int most, String what) {
        if (written == null || written.size() > most) {
            throw InvalidInput.outside(
                    ValueProblem.SIZE_OUT_OF_RANGE,
                    field,
                    "at most " + most + " " + what,
                    written == null ? "nothing" : written.size(),
                    ProblemParameter.MOST.is(most));
        }
        return written;
    }

    static boolean inside(String at, @Nullable Boolean inside) {
        if (inside == null) {
            throw InvalidInput.missing(at + "inside", "true or false");
        }
        return inside;
    }

    static List<Geodetic> corners(String at, @Nullable List<FenceView.FencePointView> corners) {
        if (corners == null
                || corners.size() < FenceArea.Polygon.LEAST_CORNERS
                || corners.size() > FenceArea.Polygon.MOST_CORNERS) {
            throw InvalidInput.outside(
                    ValueProblem.SIZE_OUT_OF_RANGE,
                    at + "corners",
                    CORNERS,
                    corners == null ? "nothing" : corners.size(),
                    ProblemParameter.LEAST.is(FenceArea.Polygon.LEAST_CORNERS),
                    ProblemParameter.MOST.is(FenceArea.Polygon.MOST_CORNERS));
        }
        List<Geodetic> read = new ArrayList<>();
        for (int index = 0; index < corners.size(); index++) {
            read.add(point(at + "corners[" + index + "].", corners.get(index)));
        }
        return read;
    }

    static Geodetic point(String at, FenceView.@Nullable FencePointView point) {
        return FieldRanges.point(at, point == null ? null : point.latitude(), point == null ? null : point.longitude());
    }

    static List<RallyPoint> rally(FenceView.RallyView written) {
        whole(written.leftOut());
        List<FenceView.RallyPointView> points =
                counted("points", written.points(), SetRallyPoints.MOST_POINTS, "points");
        List<RallyPoint> read = new ArrayList<>();
        for (int index = 0; index < points.size(); index++) {
            String at = "points[" + index + "].";
            FenceView.RallyPointView one = points.get(index);
            if (one == null) {
                throw InvalidInput.missing("points[" + index + "]", "a rally point");
            }
            read.add(new RallyPoint(
                    FieldRanges.point(at, one.latitude(), one.longitude()),
                    FieldRanges.altitude(at + "altitude", one.altitude()),
                    reference(at + "altitudeReference", one.altitudeReference())));
        }
        return read;
    }

    private static HeightReference reference(String field, @Nullable String name) {
        return switch (name == null ? "home" : name) {
            case "home" -> HeightReference.HOME;
            case "amsl" -> HeightReference.AMSL;
            case "terrain" -> HeightReference.TERRAIN;
            default ->
                throw InvalidInput.outside(
                        ValueProblem.VALUE_NOT_ALLOWED, field, "home, amsl or terrain", "\"" + name + "\"");
        };
    }
}
