package org.dronemap.cognitive.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.stream.IntStream;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlaneSegment;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.zone.AltitudeBand;
import org.junit.jupiter.api.Test;

/** Ways home of drones that leave their tours anywhere: 10 m beside each other, or 5 m and one of room above each other. */
class WaysHomeTest {
    private static final double GROUND = 400;

    private final List<Craft> crafts = new ArrayList<>();
    private final List<Tour> tours = new ArrayList<>();
    private final List<Barrier> barriers = new ArrayList<>();

    /** From its pad up, to the places, and back. */
    private void flies(double ground, double[] pad, double height, double[]... places) {
        int number = crafts.size();
        Craft craft = Craft.atHome(
                new DroneId("d" + number), PlanningFixtures.place(pad[0], pad[1], ground), PlanningFixtures.copter());
        Place home = craft.finish().place();
        List<TourStop> stops = new ArrayList<>();
        Place from = home;
        for (double[] place : places) {
            Place to = PlanningFixtures.place(place[0], place[1], height);
            stops.add(new TourStop("w", leg(from, from.at(height), to), 0, 0, 0));
            from = to;
        }
        crafts.add(craft);
        tours.add(new Tour(craft.id(), stops, leg(from, home.at(height), home), 0));
    }

    private static TourLeg leg(Place... places) {
        List<TimedPlace> fixes = new ArrayList<>();
        for (Place place : places) {
            fixes.add(new TimedPlace(place, fixes.size()));
        }
        return new TourLeg(fixes, 0);
    }

    private static double[] at(double east, double north) {
        return new double[] {east, north};
    }

    /** From pads in a row to one place. */
    private void cross(int count, double east, double height) {
        for (int i = 0; i < count; i++) {
            flies(GROUND, at(east + 20 * i, 0), height, at(east, 100));
        }
    }

    private void ceiling(double amsl) {
        barriers.add(new Barrier(
                "the zone “Field”",
                new FenceArea.Circle(true, PlanningFixtures.point(0, 0), 20_000),
                new AltitudeBand(null, amsl, Altitude.Reference.AMSL),
                Set.of()));
    }

    /** Forbidden across the way of those that {@link #cross}. */
    private void forbidden(AltitudeBand band) {
        barriers.add(new Barrier(
                "the no-fly zone “Mast”",
                new FenceArea.Circle(false, PlanningFixtures.point(0, 50), 20),
                band,
                Set.of()));
    }

    private WaysHome ways() {
        PlanningProblem problem =
                PlanningProblem.of(List.<Waypoint>of(), crafts).withBarriers(barriers);
        return WaysHome.of(problem, new Plan(tours, List.of()), drone -> true);
    }

    private List<Double> heights() {
        WaysHome ways = ways();
        return crafts.stream()
                .flatMap(craft -> ways.height(craft.id()).stream())
                .sorted()
                .toList();
    }

    private WaysHome.Shortage shortage() {
        return ways().shortage().orElseThrow();
    }

    @Test
    void waysThatCrossHaveALayerEachBelowTheCeiling() {
        cross(7, 0, 420);
        ceiling(440);

        // At 26, 32 and 38 m; the next one would be at 44 m.
        WaysHome.Shortage shortage = shortage();
        assertThat(shortage.drones()).isEqualTo(7);
        assertThat(shortage.fitting()).isEqualTo(3);
        assertThat(shortage.flownMeters()).isEqualTo(20);
        assertThat(shortage.isFlown()).isTrue();
        assertThat(shortage.ceilingMeters()).isEqualTo(40);
        assertThat(shortage.apartMeters()).isEqualTo(6);
        assertThat(shortage.unevenMeters()).isEqualTo(6);
        assertThat(heights()).containsExactly(26.0, 32.0, 38.0);
    }

    @Test
    void asManyAsThereAreLayersAllHaveAWayHome() {
        cross(3, 0, 420);
        ceiling(438);
        assertThat(ways().shortage()).isEmpty();
        assertThat(heights()).containsExactly(26.0, 32.0, 38.0);
        barriers.clear();
        ceiling(437.9);
        assertThat(shortage().fitting()).isEqualTo(2);
    }

    @Test
    void withoutACeilingAllHaveAWayHome() {
        cross(20, 0, 420);
        assertThat(ways().shortage()).isEmpty();
        // Of these none higher than 120 m above home: 26, 32 … 116.
        assertThat(heights()).hasSize(16).doesNotHaveDuplicates().endsWith(116.0);
    }

    @Test
    void whoComesNearNobodyNeedsNoLayer() {
        for (int i = 0; i < 7; i++) {
            flies(GROUND, at(100 * i, 0), 420, at(100 * i, 80));
        }
        ceiling(422);
        assertThat(ways().shortage()).isEmpty();
    }

    @Test
    void groupsFarFromEachOtherShareLayersWhereThereAreTooFew() {
        cross(3, 0, 420);
        cross(3, 400, 420);
        ceiling(440);
        assertThat(ways().shortage()).isEmpty();
        assertThat(heights()).containsExactly(26.0, 26.0, 32.0, 32.0, 38.0, 38.0);
        barriers.clear();
        ceiling(460);
        assertThat(heights()).containsExactly(26.0, 32.0, 38.0, 44.0, 50.0, 56.0);
    }

    @Test
    void homesThatAreNotLevelNeedTenMetresMore() {
        flies(GROUND, at(0, 0), 420, at(0, 100));
        flies(GROUND + 5, at(20, 0), 420, at(0, 100));
        ceiling(451);
        // 16 m above the highest way of the other one, and 16 m above that: 436 and 452.
        WaysHome.Shortage shortage = shortage();
        assertThat(shortage.fitting()).isEqualTo(1);
        assertThat(shortage.apartMeters()).isEqualTo(6);
        assertThat(shortage.unevenMeters()).isEqualTo(16);
        barriers.clear();
        ceiling(452);
        assertThat(ways().shortage()).isEmpty();
        assertThat(heights()).containsExactly(36.0, 47.0);
    }

    @Test
    void noneReturnsBelowTheHeightAtWhichVehiclesReturnUnasked() {
        cross(2, 0, 405);
        ceiling(426);
        // 15 m, then 21 and 27 m.
        WaysHome.Shortage shortage = shortage();
        assertThat(shortage.fitting()).isEqualTo(1);
        assertThat(shortage.flownMeters()).isEqualTo(15);
        assertThat(shortage.isFlown()).isFalse();
    }

    @Test
    void aForbiddenAreaOnTheWayIsACeilingOrIsFlownOver() {
        cross(2, 0, 420);
        forbidden(new AltitudeBand(30.0, null, Altitude.Reference.HOME));
        assertThat(shortage().fitting()).isEqualTo(1);
        assertThat(shortage().ceilingMeters()).isEqualTo(30);
        barriers.clear();
        forbidden(new AltitudeBand(0.0, 35.0, Altitude.Reference.HOME));
        assertThat(ways().shortage()).isEmpty();
        assertThat(heights()).containsExactly(36.0, 42.0);
    }

    @Test
    void oneAloneAndOthersThatDoNotHoverAreNeverTooMany() {
        cross(1, 0, 420);
        ceiling(421);
        assertThat(ways().shortage()).isEmpty();
        flies(GROUND, at(20, 0), 420, at(0, 100));
        assertThat(shortage().drones()).isEqualTo(2);
        PlanningProblem problem =
                PlanningProblem.of(List.<Waypoint>of(), crafts).withBarriers(barriers);
        assertThat(WaysHome.of(problem, new Plan(tours, List.of()), drone -> drone.equals(new DroneId("d0")))
                        .shortage())
                .isEmpty();
    }

    /** Compared point by point with all straight ways from their places to their pads. */
    @Test
    void noTwoWaysComeNearEachOtherWhereverTheyBegin() {
        int full = 0;
        for (int seed = 0; seed < 200; seed++) {
            Random chance = new Random(seed);
            crafts.clear();
            tours.clear();
            barriers.clear();
            int count = 2 + chance.nextInt(10);
            for (int i = 0; i < count; i++) {
                double east = 300 * chance.nextDouble();
                flies(
                        GROUND + (chance.nextInt(5) == 0 ? 4 : 0),
                        at(east, 0),
                        410 + 10 * chance.nextInt(3),
                        at(east + 60 * chance.nextDouble(), 100 * chance.nextDouble()),
                        at(east - 60 * chance.nextDouble(), 100));
            }
            ceiling(435 + 60 * chance.nextDouble());
            WaysHome ways = ways();
            full += ways.shortage().isPresent() ? 1 : 0;
            requireApart(ways, seed);
        }
        assertThat(full).isBetween(20, 180);
    }

    private void requireApart(WaysHome ways, int seed) {
        for (int i = 0; i < crafts.size(); i++) {
            for (int j = 0; j < i; j++) {
                double one = ways.height(crafts.get(i).id()).orElse(Double.NaN)
                        + crafts.get(i).homeAmslMeters();
                double other = ways.height(crafts.get(j).id()).orElse(Double.NaN)
                        + crafts.get(j).homeAmslMeters();
                double level = crafts.get(i).homeAmslMeters() == crafts.get(j).homeAmslMeters() ? 0 : 10;
                if (Math.abs(one - other) < 6 + level - 1e-6) {
                    assertThat(nearest(tours.get(i), tours.get(j)))
                            .as("seed %d, %d and %d", seed, i, j)
                            .isGreaterThan(9.9);
                }
            }
        }
    }

    private static double nearest(Tour one, Tour other) {
        return waysHome(one).stream()
                .flatMapToDouble(way -> waysHome(other).stream().mapToDouble(another -> another.distanceMeters(way)))
                .min()
                .orElseThrow();
    }

    /** Ten from each stretch. */
    private static List<PlaneSegment> waysHome(Tour tour) {
        LocalPlane plane = new LocalPlane(PlanningFixtures.point(0, 0));
        return tour.ways().stream()
                .flatMap(leg -> IntStream.range(1, leg.fixes().size())
                        .mapToObj(n -> leg.fixes().subList(n - 1, n + 1)))
                .map(pair -> new PlaneSegment(
                        plane.spot(pair.get(0).place().point()),
                        plane.spot(pair.get(1).place().point())))
                .flatMap(stretch -> IntStream.rangeClosed(0, 10)
                        .mapToObj(share -> new PlaneSegment(
                                stretch.at(share / 10.0),
                                plane.spot(tour.last().to().point()))))
                .toList();
    }

    @Test
    void theHeightIsAWholeNumberOfMetresAboveHome() {
        cross(2, 0, 420.4);
        assertThat(heights())
                .hasSize(2)
                .allSatisfy(height -> assertThat(height).isCloseTo(Math.rint(height), offset(1e-6)));
        assertThat(heights()).containsExactly(27.0, 33.0);
    }
}
