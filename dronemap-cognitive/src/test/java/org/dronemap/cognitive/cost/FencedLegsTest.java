package org.dronemap.cognitive.cost;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.plan.Plan;
import org.dronemap.cognitive.plan.PlanChecker;
import org.dronemap.cognitive.plan.TimedPlace;
import org.dronemap.cognitive.plan.TourLeg;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Finish;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Start;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.zone.AltitudeBand;
import org.junit.jupiter.api.Test;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;

/** Ways round zones: judged by an exact geometry library, a grid, and the gate that later lets the missions through. */
class FencedLegsTest {
    private static final double[][] WALL = {{-20, -200}, {20, -200}, {20, 100}, {-20, 100}};

    /** From there to there at 450 m, all the way in the air. */
    private static CostModel between(List<Barrier> barriers, double[] from, double[] to) {
        Craft craft = PlanningFixtures.craft(0, 0, 0)
                .with(Start.inFlight(PlanningFixtures.place(from[0], from[1], 450)))
                .with(Finish.hovering(PlanningFixtures.place(to[0], to[1], 450)));
        return CostModel.of(PlanningProblem.of(List.of(), List.of(craft)).withBarriers(barriers));
    }

    private static TourLeg way(CostModel model) {
        return model.plan(new int[][] {{}}).tours().get(0).last();
    }

    private static Geometry line(TourLeg way) {
        return RandomZones.SHAPES.createLineString(way.fixes().stream()
                .map(fix -> RandomZones.coordinate(fix.place().point()))
                .toArray(Coordinate[]::new));
    }

    private static boolean leads(CostModel model) {
        return model.instance().legs().seconds(0, 0, 1) < Double.POSITIVE_INFINITY;
    }

    @Test
    void goesRoundAWallByTheShorterEnd() {
        RandomZones field = new RandomZones();
        field.polygon(false, WALL);
        CostModel model = between(field.barriers, new double[] {-200, 0}, new double[] {200, 0});

        TourLeg way = way(model);

        assertThat(way.via())
                .hasSize(2)
                .allSatisfy(place ->
                        assertThat(RandomZones.coordinate(place.point()).y).isCloseTo(103, within(0.1)));
        double expected = 2 * Math.hypot(177, 103) + 46;
        assertThat(model.instance().legs().meters(0, 0, 1)).isCloseTo(expected, within(0.5));
        assertThat(model.instance().legs().seconds(0, 0, 1)).isCloseTo(expected / 10, within(0.05));
        assertThat(way.arrivesSeconds()).isCloseTo(expected / 10, within(0.05));
        assertThat(way.joules()).isCloseTo(model.instance().legs().joules(0, 0, 1), within(1e-6));
    }

    @Test
    void findsNoWayIntoAZoneOrOutOfOne() {
        RandomZones field = new RandomZones();
        field.polygon(false, WALL);

        assertThat(leads(between(field.barriers, new double[] {-200, 0}, new double[] {0, 0})))
                .isFalse();
        assertThat(leads(between(field.barriers, new double[] {0, 0}, new double[] {-200, 0})))
                .isFalse();
        field.polygon(true, new double[][] {{-300, -300}, {-10, -300}, {-10, 300}, {-300, 300}});
        assertThat(leads(between(field.barriers, new double[] {-200, 0}, new double[] {200, 0})))
                .isFalse();
    }

    @Test
    void saysWhichZoneAWaypointLiesIn() {
        RandomZones field = new RandomZones();
        field.polygon(false, WALL);
        field.polygon(true, new double[][] {{-300, -300}, {300, -300}, {300, 300}, {-300, 300}});
        List<Waypoint> waypoints = PlanningFixtures.waypoints(
                new double[] {0, 0}, new double[] {200, 0}, new double[] {400, 0}, new double[] {21, 0});
        CostModel model = CostModel.of(PlanningProblem.of(waypoints, List.of(PlanningFixtures.craft(0, -200, 0)))
                .withBarriers(field.barriers));

        assertThat(model.whyNobody(0)).hasValue("It lies where zone 0 keeps drones from.");
        assertThat(model.whyNobody(1)).isEmpty();
        assertThat(model.whyNobody(2)).hasValue("It lies where zone 1 keeps drones from.");
        assertThat(model.whyNobody(3)).isEmpty();
    }

    @Test
    void passesOverAndUnderAZoneThatEndsThere() {
        FenceArea wall = new FenceArea.Polygon(
                false,
                List.of(
                        PlanningFixtures.point(-20, -200),
                        PlanningFixtures.point(20, -200),
                        PlanningFixtures.point(20, 100),
                        PlanningFixtures.point(-20, 100)));
        assertThat(turns(wall, new AltitudeBand(null, 440.0, Altitude.Reference.AMSL)))
                .isZero();
        assertThat(turns(wall, new AltitudeBand(460.0, null, Altitude.Reference.AMSL)))
                .isZero();
        assertThat(turns(wall, new AltitudeBand(440.0, 460.0, Altitude.Reference.AMSL)))
                .isEqualTo(2);
        assertThat(turns(wall, new AltitudeBand(450.5, 460.0, Altitude.Reference.AMSL)))
                .as("within what heights may be off")
                .isEqualTo(2);
        assertThat(turns(wall, new AltitudeBand(40.0, 60.0, Altitude.Reference.HOME)))
                .as("home is at 400 m")
                .isEqualTo(2);
        assertThat(turns(wall, new AltitudeBand(60.0, 90.0, Altitude.Reference.HOME)))
                .isZero();
    }

    private static int turns(FenceArea shape, AltitudeBand band) {
        CostModel model = between(
                List.of(new Barrier("the wall", shape, band, Set.of())), new double[] {-200, 0}, new double[] {200, 0});
        return way(model).via().size();
    }

    @Test
    void bindsOnlyTheDronesThatAreNamed() {
        FenceArea wall = new FenceArea.Circle(false, PlanningFixtures.point(500, 0), 100);
        List<Waypoint> waypoints = List.of(
                Waypoint.at("a", PlanningFixtures.place(0, 0, 450)),
                Waypoint.at("b", PlanningFixtures.place(1000, 0, 450)));
        Craft bound = PlanningFixtures.craft(0, 0, 300);
        Craft free = PlanningFixtures.craft(1, 0, -300);
        CostModel model = CostModel.of(PlanningProblem.of(waypoints, List.of(bound, free))
                .withBarriers(List.of(new Barrier("the wall", wall, AltitudeBand.ALL, Set.of(new DroneId("d0"))))));
        List<AllocationDrone> carriers = model.instance().carriers();

        assertThat(model.instance().legs().meters(carriers.get(0).type(), 0, 1)).isGreaterThan(1_015);
        assertThat(model.instance().legs().meters(carriers.get(1).type(), 0, 1)).isCloseTo(1_000, within(0.5));
    }

    @Test
    void neitherTakesOffNorLandsThroughAZone() {
        FenceArea over = new FenceArea.Circle(false, PlanningFixtures.point(0, 0), 30);
        AltitudeBand above = new AltitudeBand(430.0, null, Altitude.Reference.AMSL);
        List<Waypoint> waypoints = List.of(
                Waypoint.at("high", PlanningFixtures.place(300, 0, 450)),
                Waypoint.at("low", PlanningFixtures.place(300, 0, 420)));
        CostModel model = CostModel.of(PlanningProblem.of(waypoints, List.of(PlanningFixtures.craft(0, 0, 0)))
                .withBarriers(List.of(new Barrier("the lid", over, above, Set.of()))));

        assertThat(model.instance().legs().seconds(0, 2, 0)).isInfinite();
        assertThat(model.instance().legs().seconds(0, 0, 3)).isInfinite();
        assertThat(model.instance().legs().seconds(0, 2, 1)).isFinite();
        assertThat(model.instance().legs().seconds(0, 1, 3)).isFinite();
        assertThat(model.whyNobody(0).orElseThrow()).startsWith("No way leads there");

        AltitudeBand between = new AltitudeBand(425.0, 435.0, Altitude.Reference.AMSL);
        Legs layer = CostModel.of(PlanningProblem.of(waypoints, List.of(PlanningFixtures.craft(0, 0, 0)))
                        .withBarriers(List.of(new Barrier("the layer", over, between, Set.of()))))
                .instance()
                .legs();
        assertThat(layer.seconds(0, 2, 0)).as("up through it").isInfinite();
        assertThat(layer.seconds(0, 0, 3)).as("down through it").isInfinite();
        assertThat(layer.seconds(0, 2, 1)).isFinite();
    }

    @Test
    void neverCrossesWhatIsInTheWay() {
        SplittableRandom random = new SplittableRandom(20_261_121);
        int detours = 0;
        int unreached = 0;
        for (int round = 0; round < 1_000; round++) {
            RandomZones field = RandomZones.random(random);
            CostModel model = between(field.barriers, spot(random), spot(random));
            if (!leads(model)) {
                unreached++;
                continue;
            }
            TourLeg way = way(model);
            detours += way.via().isEmpty() ? 0 : 1;
            assertThat(field.clearance(line(way))).as("round " + round).isGreaterThan(0.3);
            assertThat(PlanChecker.faults(model.problem(), model.plan(new int[][] {{}})))
                    .isEmpty();
            assertThat(way.arrivesSeconds()).isCloseTo(model.instance().legs().seconds(0, 0, 1), within(1e-6));
        }
        assertThat(detours).as("of 1,000").isGreaterThan(200);
        assertThat(unreached).as("of 1,000").isLessThan(700);
    }

    @Test
    void isNoLongerThanTheAnswerOfAGrid() {
        SplittableRandom random = new SplittableRandom(7);
        int compared = 0;
        for (int round = 0; round < 120; round++) {
            RandomZones field = RandomZones.random(random);
            double[] from = spot(random);
            double[] to = spot(random);
            CostModel model = between(field.barriers, from, to);
            GridShortestPath grid = new GridShortestPath(field, 8, 3);
            double rough = grid.meters(new Coordinate(from[0], from[1]), new Coordinate(to[0], to[1]));
            if (rough < Double.POSITIVE_INFINITY) {
                compared++;
                assertThat(model.instance().legs().meters(0, 0, 1))
                        .as("round " + round)
                        .isLessThanOrEqualTo(rough * 1.01 + 2 * grid.cell());
            }
        }
        assertThat(compared).isGreaterThan(25);
    }

    private static double[] spot(SplittableRandom random) {
        return new double[] {
            random.nextDouble(-RandomZones.HALF_METERS, RandomZones.HALF_METERS),
            random.nextDouble(-RandomZones.HALF_METERS, RandomZones.HALF_METERS)
        };
    }

    @Test
    void answersTheSameOnABigProblemWhereNotAllWaysAreKept() {
        SplittableRandom random = new SplittableRandom(3);
        RandomZones field = RandomZones.random(random);
        field.polygon(false, WALL);
        List<Waypoint> few = waypoints(random, 100);
        List<Waypoint> many = new ArrayList<>(few);
        SplittableRandom more = new SplittableRandom(4);
        for (int i = 100; i < 2_000; i++) {
            double[] spot = spot(more);
            many.add(PlanningFixtures.waypoint(i, spot[0], spot[1]));
        }
        Legs small = CostModel.of(
                        PlanningProblem.of(few, PlanningFixtures.crafts(1)).withBarriers(field.barriers))
                .instance()
                .legs();
        Legs big = CostModel.of(
                        PlanningProblem.of(many, PlanningFixtures.crafts(1)).withBarriers(field.barriers))
                .instance()
                .legs();

        for (int from = 0; from < 100; from++) {
            for (int to = 0; to < 100; to++) {
                assertThat(big.seconds(0, from, to)).isCloseTo(small.seconds(0, from, to), within(0.05));
                assertThat(small.meters(0, from, to)).isCloseTo(small.meters(0, to, from), within(1e-6));
            }
        }
    }

    @Test
    void answersTheSameToSeveralThreadsAtOnce() {
        SplittableRandom random = new SplittableRandom(8);
        RandomZones field = RandomZones.random(random);
        PlanningProblem problem = PlanningProblem.of(waypoints(random, 80), PlanningFixtures.crafts(2))
                .withBarriers(field.barriers);
        Legs alone = CostModel.of(problem).instance().legs();
        Legs shared = CostModel.of(problem).instance().legs();

        double[] together = IntStream.range(0, 80 * 80)
                .parallel()
                .mapToDouble(pair -> shared.seconds(0, pair / 80, pair % 80))
                .toArray();

        for (int pair = 0; pair < together.length; pair++) {
            assertThat(together[pair]).isEqualTo(alone.seconds(0, pair / 80, pair % 80));
        }
    }

    private static List<Waypoint> waypoints(SplittableRandom random, int count) {
        double[][] spots = new double[count][];
        for (int i = 0; i < count; i++) {
            spots[i] = spot(random);
        }
        return PlanningFixtures.waypoints(spots);
    }

    @Test
    void turnsHighEnoughForBothEnds() {
        Craft craft = PlanningFixtures.craft(0, -200, 0);
        Waypoint beyond = Waypoint.at("beyond", PlanningFixtures.place(200, 0, 480));
        RandomZones field = new RandomZones();
        field.polygon(false, WALL);
        CostModel model =
                CostModel.of(PlanningProblem.of(List.of(beyond), List.of(craft)).withBarriers(field.barriers));
        Plan plan = model.plan(new int[][] {{0}});

        assertThat(PlanChecker.faults(model.problem(), plan)).isEmpty();
        assertThat(plan.tours().get(0).last().via())
                .extracting(Place::altitudeAmslMeters)
                .containsOnly(480.0);
        assertThat(plan.tours().get(0).stops().get(0).way().fixes())
                .extracting(TimedPlace::place)
                .extracting(Place::altitudeAmslMeters)
                .containsExactly(400.0, 480.0, 480.0, 480.0, 480.0);
    }
}
