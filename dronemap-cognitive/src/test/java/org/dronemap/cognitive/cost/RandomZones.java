package org.dronemap.cognitive.cost;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.zone.AltitudeBand;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;

/** Keep-outs of all shapes strewn over a square, sometimes within an area to stay in; as zones and as exact geometry. */
final class RandomZones {
    static final double HALF_METERS = 300;
    static final GeometryFactory SHAPES = new GeometryFactory();

    final List<Barrier> barriers = new ArrayList<>();
    final List<Geometry> outs = new ArrayList<>();
    final List<Geometry> stays = new ArrayList<>();

    static RandomZones random(SplittableRandom random) {
        RandomZones field = new RandomZones();
        int count = random.nextInt(3, 14);
        for (int i = 0; i < count; i++) {
            double x = random.nextDouble(-HALF_METERS, HALF_METERS);
            double y = random.nextDouble(-HALF_METERS, HALF_METERS);
            double radius = random.nextDouble(10, 120);
            if (random.nextInt(4) == 0) {
                field.circle(x, y, radius);
            } else {
                field.polygon(false, star(random, x, y, radius));
            }
        }
        if (random.nextInt(4) == 0) {
            field.polygon(true, star(random, 0, 0, 1.6 * HALF_METERS));
        }
        return field;
    }

    private static double[][] star(SplittableRandom random, double x, double y, double radius) {
        double[][] corners = new double[random.nextInt(3, 10)][];
        for (int i = 0; i < corners.length; i++) {
            double angle = 2 * Math.PI * (i + random.nextDouble(0.8)) / corners.length;
            double away = radius * random.nextDouble(0.35, 1);
            corners[i] = new double[] {x + away * Math.cos(angle), y + away * Math.sin(angle)};
        }
        return corners;
    }

    void circle(double x, double y, double radius) {
        barrier(new FenceArea.Circle(false, PlanningFixtures.point(x, y), radius));
        outs.add(SHAPES.createPoint(new Coordinate(x, y)).buffer(radius, 64));
    }

    void polygon(boolean inside, double[][] corners) {
        List<Geodetic> points = new ArrayList<>();
        Coordinate[] ring = new Coordinate[corners.length + 1];
        for (int i = 0; i < corners.length; i++) {
            points.add(PlanningFixtures.point(corners[i][0], corners[i][1]));
            ring[i] = new Coordinate(corners[i][0], corners[i][1]);
        }
        ring[corners.length] = ring[0];
        barrier(new FenceArea.Polygon(inside, points));
        (inside ? stays : outs).add(SHAPES.createPolygon(ring));
    }

    private void barrier(FenceArea shape) {
        barriers.add(new Barrier("zone " + barriers.size(), shape, AltitudeBand.ALL, Set.of()));
    }

    /** The least distance between a way and all that it must not touch; negative when it does. */
    double clearance(Geometry way) {
        double least = Double.POSITIVE_INFINITY;
        for (Geometry out : outs) {
            least = Math.min(least, out.intersects(way) ? -1 : out.distance(way));
        }
        for (Geometry stay : stays) {
            least = Math.min(least, stay.contains(way) ? stay.getBoundary().distance(way) : -1);
        }
        return least;
    }

    /** All that a drone must not touch, and so much around it. */
    Geometry taken(double room) {
        Geometry all = SHAPES.buildGeometry(outs).buffer(room);
        Geometry world = SHAPES.createPoint(new Coordinate(0, 0)).buffer(10 * HALF_METERS);
        for (Geometry stay : stays) {
            all = all.union(world.difference(stay.buffer(-room)));
        }
        return all;
    }

    static Coordinate coordinate(Geodetic point) {
        return new Coordinate(
                (point.longitudeDegrees() - PlanningFixtures.LONGITUDE) * PlanningFixtures.METERS_PER_DEGREE_EAST,
                (point.latitudeDegrees() - PlanningFixtures.LATITUDE) * PlanningFixtures.METERS_PER_DEGREE_NORTH);
    }
}
