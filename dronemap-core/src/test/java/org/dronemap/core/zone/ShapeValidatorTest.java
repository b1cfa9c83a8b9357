package org.dronemap.core.zone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.FenceArea;
import org.junit.jupiter.api.Test;

class ShapeValidatorTest {
    @Test
    void takesAnOrdinaryArea() {
        assertThat(ShapeValidator.of(ZoneFixtures.square(false, 0, 0))).isEmpty();
    }

    @Test
    void refusesAnEdgeThatCrossesItself() {
        assertThat(fault(
                        ZoneFixtures.at(0, 0),
                        ZoneFixtures.at(0.001, 0.001),
                        ZoneFixtures.at(0, 0.001),
                        ZoneFixtures.at(0.001, 0)))
                .isEqualTo("The edge of the area crosses or touches itself: the edge after corner 1 and the edge after"
                        + " corner 3.");
    }

    @Test
    void refusesAnEdgeThatFoldsBackOnItself() {
        assertThat(fault(
                        ZoneFixtures.at(0, 0),
                        ZoneFixtures.at(0, 0.002),
                        ZoneFixtures.at(0, 0.001),
                        ZoneFixtures.at(0.001, 0.001)))
                .startsWith("The edge of the area crosses or touches itself");
    }

    @Test
    void refusesAnAreaWithoutArea() {
        assertThat(fault(ZoneFixtures.at(0, 0), ZoneFixtures.at(0.000005, 0), ZoneFixtures.at(0, 0.000005)))
                .isEqualTo("The area is only 0.10 m²; it must be at least 1 m² to be guarded.");
    }

    @Test
    void refusesACornerThatIsThereTwice() {
        assertThat(fault(
                        ZoneFixtures.at(0, 0),
                        ZoneFixtures.at(0, 0),
                        ZoneFixtures.at(0, 0.001),
                        ZoneFixtures.at(0.001, 0)))
                .isEqualTo("Corners 1 and 2 are the same place.");
    }

    @Test
    void takesAnAreaAcrossTheDateLineTheShortWayRound() {
        assertThat(ShapeValidator.of(new FenceArea.Polygon(
                        false,
                        List.of(
                                new Geodetic(-17, 179.9),
                                new Geodetic(-17, -179.9),
                                new Geodetic(-16.9, -179.9),
                                new Geodetic(-16.9, 179.9)))))
                .isEmpty();
    }

    @Test
    void refusesHalfTheWorldAndThePoles() {
        assertThat(fault(new Geodetic(10, -100), new Geodetic(10, 100), new Geodetic(20, 0)))
                .startsWith("The area is wider than 200 km; divide it.");
        assertThat(ShapeValidator.of(new FenceArea.Circle(false, new Geodetic(86, 0), 500)))
                .contains("Zones within 5 degrees of a pole are not supported.");
    }

    @Test
    void makesNoZoneOfWhatCannotBeGuarded() {
        FenceArea crossed = polygon(
                ZoneFixtures.at(0, 0),
                ZoneFixtures.at(0.001, 0.001),
                ZoneFixtures.at(0, 0.001),
                ZoneFixtures.at(0.001, 0));
        assertThatThrownBy(() -> ZoneFixtures.zone(crossed)).hasMessageContaining("crosses or touches itself");
    }

    private static String fault(Geodetic... corners) {
        return ShapeValidator.of(polygon(corners)).orElse("nothing");
    }

    private static FenceArea polygon(Geodetic... corners) {
        return new FenceArea.Polygon(false, List.of(corners));
    }
}
