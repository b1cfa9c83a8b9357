package org.dronemap.ws.plan;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.zone.Zone;
import org.dronemap.core.zone.ZoneRegistry;

/**
 * Collects the cloud's zones that bind the drones of a plan and lie near its waypoints, as barriers for the planner.
 */
public final class PlanBarriers {
    /** What comes into force while they fly counts already. */
    private static final Duration AHEAD = Duration.ofHours(1);
    /** Ways round zones lead out of the area of the places by this at least. */
    private static final double LEAST_MARGIN_METERS = 2_000;

    private final LocalPlane plane;
    private final double west;
    private final double east;
    private final double south;
    private final double north;

    private PlanBarriers(List<Waypoint> waypoints, List<Craft> crafts) {
        plane = new LocalPlane(crafts.get(0).start().place().point());
        List<PlanePoint> spots = Stream.concat(
                        waypoints.stream().map(Waypoint::place),
                        crafts.stream()
                                .flatMap(craft -> Stream.of(
                                        craft.start().place(), craft.finish().place())))
                .map(place -> plane.spot(place.point()))
                .toList();
        double left = spots.stream().mapToDouble(PlanePoint::eastMeters).min().orElse(0);
        double right = spots.stream().mapToDouble(PlanePoint::eastMeters).max().orElse(0);
        double low = spots.stream().mapToDouble(PlanePoint::northMeters).min().orElse(0);
        double high = spots.stream().mapToDouble(PlanePoint::northMeters).max().orElse(0);
        double margin = LEAST_MARGIN_METERS + Math.max(right - left, high - low) / 2;
        west = left - margin;
        east = right + margin;
        south = low - margin;
        north = high + margin;
    }

    public static List<Barrier> of(
            String user, ZoneRegistry book, List<Waypoint> waypoints, List<Craft> crafts, Instant now) {
        PlanBarriers near = new PlanBarriers(waypoints, crafts);
        Map<Zone, Set<DroneId>> bound = new LinkedHashMap<>();
        for (Craft craft : crafts) {
            book.binding(user, craft.id(), now, now.plus(AHEAD)).stream()
                    .filter(near::isNear)
                    .forEach(zone -> bound.computeIfAbsent(zone, each -> new LinkedHashSet<>())
                            .add(craft.id()));
        }
        List<Barrier> barriers = new ArrayList<>();
        bound.forEach((zone, drones) -> barriers.add(new Barrier(
                zone.words(), zone.shape(), zone.band(), drones.size() == crafts.size() ? Set.of() : drones)));
        return barriers;
    }

    /** What drones have to stay in counts wherever it lies. */
    private boolean isNear(Zone zone) {
        if (zone.shape().inside()) {
            return true;
        }
        if (zone.shape() instanceof FenceArea.Circle circle) {
            return meets(List.of(plane.spot(circle.center())), circle.radiusMeters());
        }
        return zone.shape() instanceof FenceArea.Polygon polygon && meets(spots(polygon.corners()), 0);
    }

    private List<PlanePoint> spots(List<Geodetic> corners) {
        return corners.stream().map(plane::spot).toList();
    }

    private boolean meets(List<PlanePoint> spots, double around) {
        return spots.stream().anyMatch(spot -> spot.eastMeters() + around >= west)
                && spots.stream().anyMatch(spot -> spot.eastMeters() - around <= east)
                && spots.stream().anyMatch(spot -> spot.northMeters() + around >= south)
                && spots.stream().anyMatch(spot -> spot.northMeters() - around <= north);
    }
}
