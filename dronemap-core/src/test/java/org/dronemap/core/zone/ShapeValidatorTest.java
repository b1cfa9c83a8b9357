package org.dronemap.core.zone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlaneSegment;
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

    /** Corners scattered at random cross nearly always, and those of a ragged ring do not. */
    @Test
    void namesTheFirstTwoEdgesThatCross() {
        for (int seed = 0; seed < 300; seed++) {
            Random random = new Random(seed);
            int count = 4 + random.nextInt(37);
            boolean scattered = random.nextBoolean();
            List<Geodetic> corners = IntStream.range(0, count)
                    .mapToObj(corner -> {
                        double angle = scattered ? random.nextDouble() * 7 : 2 * Math.PI * corner / count;
                        double far = 0.001 + 0.001 * random.nextDouble();
                        return ZoneFixtures.at(far * Math.sin(angle), far * Math.cos(angle));
                    })
                    .toList();

            assertThat(ShapeValidator.of(new FenceArea.Polygon(false, corners)))
                    .as("seed %d", seed)
                    .isEqualTo(crossing(corners));
        }
    }

    private static Optional<String> crossing(List<Geodetic> corners) {
        List<PlaneSegment> edges =
                new LocalPlane(corners.get(0)).outline(corners).edges();
        for (int one = 0; one < edges.size(); one++) {
            for (int other = one + 2; other < edges.size(); other++) {
                boolean neighbours = one == 0 && other == edges.size() - 1;
                if (!neighbours && edges.get(one).distanceMeters(edges.get(other)) < 0.01) {
                    return Optional.of("The edge of the area crosses or touches itself: the edge after corner "
                            + (one + 1) + " and the edge after corner " + (other + 1) + ".");
                }
            }
        }
        return Optional.empty();
    }

    private static String fault(Geodetic... corners) {
        return ShapeValidator.of(polygon(corners)).orElse("nothing");
    }

    private static FenceArea polygon(Geodetic... corners) {
        return new FenceArea.Polygon(false, List.of(corners));
    }
}
