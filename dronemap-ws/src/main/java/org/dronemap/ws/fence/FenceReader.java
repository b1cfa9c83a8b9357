package org.dronemap.ws.fence;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.mission.RallyPoint;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.FieldRanges;
import org.jspecify.annotations.Nullable;

/** Turns a geofence or rally points that a client wrote into those for a vehicle, or rejects the faulty field. */
final class FenceReader {
    static final int LEAST_CORNERS = 3;
    static final int MOST_CORNERS = 100;
    private static final String CORNERS = LEAST_CORNERS + " to " + MOST_CORNERS + " corners";
    private static final String ZONES = "at most 50 zones";
    private static final String POINTS = "at most 50 points";
    static final int MOST = 50;

    private FenceReader() {}

    static List<FenceArea> fence(FenceView written) {
        List<FenceView.ZoneView> zones = written.zones();
        if (zones == null || zones.size() > MOST) {
            throw InvalidInput.outside(
                    ValueProblem.SIZE_OUT_OF_RANGE,
                    "zones",
                    ZONES,
                    zones == null ? "nothing" : zones.size(),
                    ProblemParameter.MOST.is(MOST));
        }
        List<FenceArea> read = new ArrayList<>();
        for (int index = 0; index < zones.size(); index++) {
            read.add(zones.get(index).read("zones[" + index + "]."));
        }
        return read;
    }

    static boolean inside(String at, @Nullable Boolean inside) {
        if (inside == null) {
            throw InvalidInput.missing(at + "inside", "true or false");
        }
        return inside;
    }

    static List<Geodetic> corners(String at, @Nullable List<FenceView.FencePointView> corners) {
        if (corners == null || corners.size() < LEAST_CORNERS || corners.size() > MOST_CORNERS) {
            throw InvalidInput.outside(
                    ValueProblem.SIZE_OUT_OF_RANGE,
                    at + "corners",
                    CORNERS,
                    corners == null ? "nothing" : corners.size(),
                    ProblemParameter.LEAST.is(LEAST_CORNERS),
                    ProblemParameter.MOST.is(MOST_CORNERS));
        }
        List<Geodetic> read = new ArrayList<>();
        for (int index = 0; index < corners.size(); index++) {
            read.add(point(at + "corners[" + index + "].", corners.get(index)));
        }
        return read;
    }

    static Geodetic point(String at, FenceView.@Nullable FencePointView point) {
        return new Geodetic(
                FieldRanges.latitude(at + "latitude", point == null ? null : point.latitude()),
                FieldRanges.longitude(at + "longitude", point == null ? null : point.longitude()));
    }

    static List<RallyPoint> rally(FenceView.RallyView written) {
        List<FenceView.RallyPointView> points = written.points();
        if (points == null || points.size() > MOST) {
            throw InvalidInput.outside(
                    ValueProblem.SIZE_OUT_OF_RANGE,
                    "points",
                    POINTS,
                    points == null ? "nothing" : points.size(),
                    ProblemParameter.MOST.is(MOST));
        }
        List<RallyPoint> read = new ArrayList<>();
        for (int index = 0; index < points.size(); index++) {
            String at = "points[" + index + "].";
            FenceView.RallyPointView one = points.get(index);
            read.add(new RallyPoint(
                    point(at, new FenceView.FencePointView(one.latitude(), one.longitude())),
                    FieldRanges.checked(at + "altitude", one.altitude(), 0, 10_000, "m above home")));
        }
        return read;
    }
}
