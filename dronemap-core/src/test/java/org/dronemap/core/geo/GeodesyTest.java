package org.dronemap.core.geo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class GeodesyTest {
    private static final Geodetic ZURICH = new Geodetic(47.3769, 8.5417);
    private static final Geodetic BERN = new Geodetic(46.9480, 7.4474);

    @Test
    void measuresAKnownDistance() {
        // 95.5 km on the ellipsoid (Vincenty); the sphere is within 0.6 %.
        assertThat(Geodesy.distanceMeters(ZURICH, BERN)).isCloseTo(95_500, within(600.0));
    }

    @Test
    void measuresMetresWithoutLosingThem() {
        Geodetic aMetreNorth = new Geodetic(47.3769 + 1 / 111_195.0, 8.5417);

        assertThat(Geodesy.distanceMeters(ZURICH, aMetreNorth)).isCloseTo(1, within(0.001));
    }

    @Test
    void bearsAcrossTheDateLine() {
        double east = Geodesy.bearingDegrees(new Geodetic(0, 179.9), new Geodetic(0, -179.9));

        assertThat(east).isCloseTo(90, within(1e-9));
    }

    @Test
    void refusesPlacesThatAreNotOnEarth() {
        assertThatThrownBy(() -> new Geodetic(95, 0)).hasMessageContaining("latitude must be -90 to 90");
        assertThatThrownBy(() -> new Geodetic(Double.NaN, 0)).hasMessageContaining("latitude");
        assertThatThrownBy(() -> new Geodetic(0, 180.1)).hasMessageContaining("longitude must be -180 to 180");
    }
}
