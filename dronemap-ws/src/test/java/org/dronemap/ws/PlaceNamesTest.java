package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.core.geo.Geodetic;
import org.dronemap.ws.place.PlaceNames;
import org.junit.jupiter.api.Test;

class PlaceNamesTest {
    private static final PlaceNames PLACES = PlaceNames.load();

    @Test
    void namesThePlaceItIsAt() {
        assertThat(PLACES.near(new Geodetic(51.7520, -1.2577))).isEqualTo("Oxford, GB");
    }

    @Test
    void saysHowFarAndInWhichDirection() {
        assertThat(PLACES.near(new Geodetic(47.3977, 8.5456))).isEqualTo("3 km N of Zürich, CH");
    }

    @Test
    void looksAcrossTheDateLine() {
        assertThat(PLACES.near(new Geodetic(-16.8, -179.9))).endsWith(", FJ");
    }

    @Test
    void knowsNoPlaceOnTheOpenSea() {
        assertThat(PLACES.near(new Geodetic(-48.9, -123.4))).isNull();
        assertThat(PLACES.near(new Geodetic(90, 0))).isNull();
    }
}
