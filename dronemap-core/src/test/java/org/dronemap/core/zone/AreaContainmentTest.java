package org.dronemap.core.zone;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;
import org.dronemap.core.mission.FenceArea;
import org.junit.jupiter.api.Test;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Polygon;

class AreaContainmentTest {
    private static final GeometryFactory SHAPES = new GeometryFactory();
    private static final int PAIRS = 10_000;

    private final Random random = new Random(7);

    @Test
    void saysOfPolygonsWhatAGeometryLibrarySays() {
        int within = 0;
        for (int pair = 0; pair < PAIRS; pair++) {
            FenceArea.Polygon outer = star(ZoneFixtures.HOME, 0.01);
            FenceArea.Polygon inner = star(
                    ZoneFixtures.at(0.006 * (random.nextDouble() - 0.5), 0.006 * (random.nextDouble() - 0.5)), 0.003);
            boolean covers = shape(outer).covers(shape(inner));
            boolean held = AreaContainment.holds(outer, inner);
            if (held != covers) {
                // A millimetre is left to rounding.
                assertThat(shape(outer).buffer(1e-8).covers(shape(inner)))
                        .as("%s in %s", inner, outer)
                        .isEqualTo(held);
            }
            within += held ? 1 : 0;
        }
        assertThat(within).isBetween(PAIRS / 10, PAIRS * 9 / 10);
    }

    @Test
    void holdsWhatSharesAnEdgeOrACorner() {
        FenceArea outer = ZoneFixtures.square(true, 0, 0);

        assertThat(AreaContainment.holds(outer, outer)).isTrue();
        assertThat(AreaContainment.holds(outer, corners(-0.001, -0.001, -0.001, 0.001, 0.001, 0)))
                .isTrue();
        assertThat(AreaContainment.holds(outer, corners(-0.001, -0.001, -0.001, 0.001, 0.00101, 0)))
                .isFalse();
    }

    @Test
    void holdsNothingThatReachesAcrossANotch() {
        FenceArea notched = corners(0, 0, 0, 0.01, 0.005, 0.002, 0.01, 0.01, 0.01, 0);

        assertThat(AreaContainment.holds(notched, corners(0.001, 0.005, 0.009, 0.005, 0.005, 0.0005)))
                .isFalse();
        assertThat(AreaContainment.holds(notched, corners(0.001, 0.001, 0.009, 0.001, 0.005, 0.0005)))
                .isTrue();
    }

    /** No corner of the notch is beside the part of the edge that lies in it. */
    @Test
    void holdsNothingThatReachesAcrossASlantedNotch() {
        FenceArea slanted = corners(0, 0, 0, 0.012, 0.01, 0.012, 0.01, 0.005, 0.002, 0.009, 0.01, 0.004, 0.01, 0);

        assertThat(AreaContainment.holds(slanted, corners(0.008, 0.001, 0.008, 0.008, 0.0079, 0.001)))
                .isFalse();
        assertThat(AreaContainment.holds(slanted, corners(0.008, 0.001, 0.008, 0.005, 0.0079, 0.001)))
                .isTrue();
    }

    @Test
    void measuresCirclesFromTheirMiddle() {
        FenceArea big = circle(0, 1000);

        assertThat(AreaContainment.holds(big, circle(0, 1000))).isTrue();
        assertThat(AreaContainment.holds(big, circle(0.001, 888))).isTrue();
        assertThat(AreaContainment.holds(big, circle(0.001, 890))).isFalse();
        assertThat(AreaContainment.holds(big, ZoneFixtures.square(true, 0.007, 0)))
                .isTrue();
        assertThat(AreaContainment.holds(big, ZoneFixtures.square(true, 0.008, 0)))
                .isFalse();
        assertThat(AreaContainment.holds(ZoneFixtures.square(true, 0, 0), circle(0, 75)))
                .isTrue();
        assertThat(AreaContainment.holds(ZoneFixtures.square(true, 0, 0), circle(0, 76)))
                .isFalse();
        assertThat(AreaContainment.holds(ZoneFixtures.square(true, 0.01, 0), circle(0, 75)))
                .isFalse();
    }

    /** Far from the middle of a big circle no one flat picture has all distances right. */
    @Test
    void holdsABigCircleInAnAreaOnlyIfNoPlaceOfItsRimIsOutside() {
        FenceArea.Polygon area = (FenceArea.Polygon) corners(-0.85, -1, -0.85, 1, 0.85, 1, 0.7, -1.1);
        for (double radius = 60_000; radius <= 90_000; radius += 500) {
            FenceArea.Circle circle = new FenceArea.Circle(true, ZoneFixtures.HOME, radius);
            boolean rimInside = true;
            for (double degree = 0; degree < 360; degree += 0.25) {
                Geodetic place = rim(circle, Math.toRadians(degree));
                rimInside &= shape(area).covers(SHAPES.createPoint(coordinate(place)));
            }
            assertThat(AreaContainment.holds(area, circle)).as("%f m", radius).isEqualTo(rimInside);
        }
    }

    @Test
    void knowsNoDateLine() {
        FenceArea outer = new FenceArea.Polygon(
                true,
                List.of(new Geodetic(0, 179), new Geodetic(0, -179.5), new Geodetic(1, -179.5), new Geodetic(1, 179)));
        FenceArea inner = new FenceArea.Polygon(
                true,
                List.of(
                        new Geodetic(0.2, -179.8),
                        new Geodetic(0.2, -179.6),
                        new Geodetic(0.8, -179.6),
                        new Geodetic(0.8, 179.5)));

        assertThat(AreaContainment.holds(outer, inner)).isTrue();
        assertThat(AreaContainment.holds(inner, outer)).isFalse();
        assertThat(AreaContainment.holds(outer, new FenceArea.Circle(true, new Geodetic(0.5, 180), 50_000)))
                .isTrue();
        assertThat(AreaContainment.holds(outer, new FenceArea.Circle(true, new Geodetic(0.5, 180), 56_000)))
                .isFalse();
    }

    /** A place whose distance as circles measure it is the radius. */
    private static Geodetic rim(FenceArea.Circle circle, double angle) {
        double low = 0;
        double high = 2;
        for (int step = 0; step < 60; step++) {
            double middle = (low + high) / 2;
            PlanePoint seen = LocalPlane.offset(circle.center(), towards(circle, angle, middle));
            if (Math.hypot(seen.eastMeters(), seen.northMeters()) < circle.radiusMeters()) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return towards(circle, angle, low);
    }

    private static Geodetic towards(FenceArea.Circle circle, double angle, double degrees) {
        return new Geodetic(
                circle.center().latitudeDegrees() + degrees * Math.cos(angle),
                circle.center().longitudeDegrees() + degrees * Math.sin(angle));
    }

    private static FenceArea circle(double north, double radius) {
        return new FenceArea.Circle(true, ZoneFixtures.at(north, 0), radius);
    }

    private static FenceArea corners(double... northThenEast) {
        return new FenceArea.Polygon(
                true,
                Stream.iterate(0, index -> index < northThenEast.length, index -> index + 2)
                        .map(index -> ZoneFixtures.at(northThenEast[index], northThenEast[index + 1]))
                        .toList());
    }

    /** Some corners around a middle, in order: never crosses itself. */
    private FenceArea.Polygon star(Geodetic middle, double size) {
        int corners = 3 + random.nextInt(6);
        return new FenceArea.Polygon(
                true,
                Stream.iterate(0, index -> index < corners, index -> index + 1)
                        .map(index -> {
                            double angle = 2 * Math.PI * index / corners;
                            double away = size * (0.3 + 0.7 * random.nextDouble());
                            return new Geodetic(
                                    middle.latitudeDegrees() + away * Math.cos(angle),
                                    middle.longitudeDegrees() + away * Math.sin(angle));
                        })
                        .toList());
    }

    private static Polygon shape(FenceArea.Polygon area) {
        return SHAPES.createPolygon(
                Stream.concat(area.corners().stream(), area.corners().stream().limit(1))
                        .map(AreaContainmentTest::coordinate)
                        .toArray(Coordinate[]::new));
    }

    private static Coordinate coordinate(Geodetic place) {
        return new Coordinate(place.longitudeDegrees(), place.latitudeDegrees());
    }
}
