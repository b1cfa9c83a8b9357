package org.dronemap.core.geo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The area around points, and how far it is from another one. */
class PlaneHullTest {
    private static PlaneHull around(double[]... points) {
        return PlaneHull.around(
                Stream.of(points).map(at -> new PlanePoint(at[0], at[1])).toList());
    }

    private static double[] at(double east, double north) {
        return new double[] {east, north};
    }

    @Test
    void leavesOutWhatLiesWithin() {
        PlaneHull square = around(at(0, 0), at(10, 10), at(5, 5), at(10, 0), at(5, 0), at(0, 10), at(3, 7));
        assertThat(square.corners())
                .containsExactly(
                        new PlanePoint(0, 0), new PlanePoint(10, 0), new PlanePoint(10, 10), new PlanePoint(0, 10));
    }

    @Test
    void pointsInARowMakeAStretchAndOneAlonePoint() {
        assertThat(around(at(0, 0), at(5, 5), at(10, 10)).corners())
                .isEqualTo(List.of(new PlanePoint(0, 0), new PlanePoint(10, 10)));
        assertThat(around(at(3, 4), at(3, 4)).corners()).isEqualTo(List.of(new PlanePoint(3, 4)));
    }

    @Test
    void theDistanceIsThatOfTheNearestPoints() {
        PlaneHull square = around(at(0, 0), at(10, 0), at(10, 10), at(0, 10));
        assertThat(square.distanceMeters(around(at(14, 13)))).isCloseTo(5, offset(1e-9));
        assertThat(square.distanceMeters(around(at(17, -5), at(17, 20)))).isCloseTo(7, offset(1e-9));
        assertThat(square.distanceMeters(around(at(4, 4)))).isZero();
        assertThat(around(at(4, 4), at(5, 5)).distanceMeters(square)).isZero();
        assertThat(square.distanceMeters(around(at(-5, 5), at(15, 5)))).isZero();
    }
}
