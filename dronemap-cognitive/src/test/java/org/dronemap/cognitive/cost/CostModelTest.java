package org.dronemap.cognitive.cost;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.assertj.core.data.Offset;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.plan.Plan;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.cognitive.plan.TourLeg;
import org.dronemap.cognitive.plan.UnservedWaypoint;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.EnergyBudget;
import org.dronemap.cognitive.problem.Finish;
import org.dronemap.cognitive.problem.Performance;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Skill;
import org.dronemap.cognitive.problem.Speeds;
import org.dronemap.cognitive.problem.Start;
import org.dronemap.cognitive.problem.Task;
import org.dronemap.cognitive.problem.TimeWindow;
import org.dronemap.cognitive.problem.UniformWind;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodesy;
import org.junit.jupiter.api.Test;

/** Figures that can be worked out by hand, and plans that say the same as the legs they were searched on. */
class CostModelTest {
    private static final Offset<Double> CLOSE = within(0.1);

    private final Craft craft = PlanningFixtures.craft(0, 0, 0);
    private final List<Waypoint> two = PlanningFixtures.waypoints(new double[] {0, 1000}, new double[] {1000, 1000});

    private static Legs legs(PlanningProblem problem) {
        return CostModel.of(problem).instance().legs();
    }

    @Test
    void fliesLevelAtItsCruisingSpeed() {
        Legs legs = legs(PlanningProblem.of(two, List.of(craft)));

        assertThat(legs.seconds(0, 0, 1)).isCloseTo(100, CLOSE);
        assertThat(legs.meters(0, 0, 1)).isCloseTo(1000, within(1.0));
        assertThat(legs.joules(0, 0, 1)).isCloseTo(15_000, within(20.0));
    }

    @Test
    void takesOffToTheFirstWaypointsHeightAndLandsSlowly() {
        Legs legs = legs(PlanningProblem.of(two, List.of(craft)));

        assertThat(legs.seconds(0, 2, 0)).as("50 m up at 2 m/s, then 1000 m").isCloseTo(25 + 100, CLOSE);
        assertThat(legs.joules(0, 2, 0)).isCloseTo(25 * 200 + 15_000, within(20.0));
        assertThat(legs.seconds(0, 0, 3)).as("40 m at 1 m/s, 10 m at 0.5").isCloseTo(100 + 40 + 20, CLOSE);
        assertThat(legs.meters(0, 0, 3)).isCloseTo(1050, within(1.0));
    }

    @Test
    void climbsWhileItFliesAndTheSlowerOfTheTwoCounts() {
        List<Waypoint> steep = List.of(
                Waypoint.at("low", PlanningFixtures.place(0, 0, 450)),
                Waypoint.at("high", PlanningFixtures.place(100, 0, 550)));
        Legs legs = legs(PlanningProblem.of(steep, List.of(craft)));

        assertThat(legs.seconds(0, 0, 1)).isCloseTo(50, CLOSE);
        assertThat(legs.seconds(0, 1, 0)).isCloseTo(100, CLOSE);
        assertThat(legs.joules(0, 0, 1))
                .as("10 s cruising, 40 s hovering, 50 s climbing on top")
                .isCloseTo(10 * 150 + 40 * 100 + 50 * 100, within(20.0));
    }

    @Test
    void gathersSpeedAndBrakes() {
        Speeds lazy = new Speeds(10, 2, 1, 0.5, 15, 2.5);
        Performance performance = new Performance(
                lazy,
                PlanningFixtures.copter().power(),
                PlanningFixtures.copter().response());
        List<Waypoint> waypoints =
                PlanningFixtures.waypoints(new double[] {0, 0}, new double[] {0, 1000}, new double[] {10, 0});
        Legs legs = legs(PlanningProblem.of(waypoints, List.of(craft.with(performance))));

        assertThat(legs.seconds(0, 0, 1)).isCloseTo(104, CLOSE);
        assertThat(legs.seconds(0, 0, 2)).as("never reaches 10 m/s").isCloseTo(4, CLOSE);
    }

    @Test
    void windCarriesAeroplanesAndIsFlownAgainstByCopters() {
        UniformWind fromNorth = new UniformWind(6, 0);
        Legs plane = legs(PlanningProblem.of(two, List.of(craft.with(PlanningFixtures.aeroplane())))
                .with(fromNorth));
        Legs copter = legs(PlanningProblem.of(two, List.of(craft)).with(fromNorth));

        assertThat(plane.seconds(0, 2, 0)).as("against it: 4 m/s").isCloseTo(25 + 250, within(0.5));
        assertThat(plane.seconds(0, 0, 3)).as("with it: 16 m/s").isCloseTo(62.5 + 60, CLOSE);
        assertThat(plane.seconds(0, 0, 1)).as("across: 8 m/s").isCloseTo(125, CLOSE);
        assertThat(copter.seconds(0, 0, 1)).isCloseTo(100, CLOSE);
        assertThat(copter.joules(0, 0, 1))
                .as("hovering, and what 136 instead of 100 (m/s)² take")
                .isCloseTo(100 * (150 + 50 * 0.36), within(30.0));
    }

    @Test
    void reachesNothingAgainstWindThatIsStrongerThanItself() {
        UniformWind storm = new UniformWind(12, 0);
        Legs plane = legs(PlanningProblem.of(two, List.of(craft.with(PlanningFixtures.aeroplane())))
                .with(storm));
        Legs copter = legs(PlanningProblem.of(two, List.of(craft)).with(storm));

        assertThat(plane.seconds(0, 2, 0)).isInfinite();
        assertThat(plane.joules(0, 2, 0)).isInfinite();
        assertThat(copter.seconds(0, 2, 0))
                .as("15 m/s through the air leave 3 over ground")
                .isCloseTo(25 + 333.3, within(1.0));
    }

    @Test
    void saysWhyAWaypointCannotBeServed() {
        List<Waypoint> waypoints = List.of(
                new Waypoint(
                        "picture",
                        PlanningFixtures.place(100, 0, 450),
                        new Task(5, Set.of(new Skill("take a picture"))),
                        1,
                        TimeWindow.ALWAYS),
                Waypoint.at("far", PlanningFixtures.place(20_000, 0, 450)),
                new Waypoint("soon", PlanningFixtures.place(3_000, 0, 450), Task.FLY_THROUGH, 1, new TimeWindow(0, 60)),
                Waypoint.at("near", PlanningFixtures.place(100, 0, 450)));
        CostModel model =
                CostModel.of(PlanningProblem.of(waypoints, List.of(craft.with(EnergyBudget.ofWattHours(100, 20)))));

        assertThat(model.whyNobody(0)).hasValue("No drone in good contact can take a picture.");
        assertThat(model.whyNobody(1).orElseThrow())
                .startsWith("Out of range: even the drone that has most to spare would draw 169.")
                .endsWith("and may draw 80.0 Wh.");
        assertThat(model.whyNobody(2))
                .hasValue("No drone is there in time: the first after 325 s, the window closes after 60 s.");
        assertThat(model.whyNobody(3)).isEmpty();
        assertThat(model.plan(new int[][] {{3}}).unserved())
                .extracting(UnservedWaypoint::waypoint)
                .containsExactly("picture", "far", "soon");
    }

    @Test
    void givesNothingToADroneWithABadLink() {
        CostModel model = CostModel.of(PlanningProblem.of(two, List.of(craft.withLinkQuality(0.3))));

        assertThat(model.instance().visits().get(0).drones().isEmpty()).isTrue();
        assertThat(model.whyNobody(0)).hasValue("No drone has a link that is good enough (0.50 is asked for).");
    }

    @Test
    void writesDownWhatTheLegsSay() {
        SplittableRandom random = new SplittableRandom(5);
        for (int round = 0; round < 200; round++) {
            List<Waypoint> waypoints = PlanningFixtures.waypoints(spot(random), spot(random), spot(random));
            Craft flying = craft.with(Performance.of(VehicleKind.MULTICOPTER))
                    .with(round % 2 == 0 ? Start.inFlight(PlanningFixtures.place(50, 50, 430)) : craft.start())
                    .with(round % 3 == 0 ? Finish.hovering(PlanningFixtures.place(9, 9, 440)) : craft.finish());
            CostModel model =
                    CostModel.of(PlanningProblem.of(waypoints, List.of(flying)).with(new UniformWind(5, 120)));
            Legs legs = model.instance().legs();

            Tour tour = model.plan(new int[][] {{2, 0, 1}}).tours().get(0);

            int[] places = {3, 2, 0, 1, 4};
            for (int i = 0; i < 4; i++) {
                TourLeg way = tour.ways().get(i);
                assertThat(way.arrivesSeconds() - way.departsSeconds())
                        .isCloseTo(legs.seconds(0, places[i], places[i + 1]), within(1e-6));
                assertThat(way.joules()).isCloseTo(legs.joules(0, places[i], places[i + 1]), within(1e-3));
            }
        }
    }

    private static double[] spot(SplittableRandom random) {
        return new double[] {random.nextDouble(-3000, 3000), random.nextDouble(-3000, 3000)};
    }

    @Test
    void leavesAnIdleDroneOnTheGroundAndBringsAFlyingOneHome() {
        Craft flying = PlanningFixtures.craft(1, 0, 0).with(Start.inFlight(PlanningFixtures.place(500, 0, 450)));
        Plan plan =
                CostModel.of(PlanningProblem.of(two, List.of(craft, flying))).plan(new int[][] {{}, {}});

        assertThat(plan.tours()).hasSize(1);
        assertThat(plan.tours().get(0).drone()).isEqualTo(flying.id());
        assertThat(plan.endsSeconds()).isCloseTo(50 + 40 + 20, CLOSE);
        assertThat(plan.unserved()).hasSize(2);
    }

    @Test
    void waitsForAWindowAndPaysForIt() {
        List<Waypoint> late = List.of(new Waypoint(
                "late", PlanningFixtures.place(1000, 0, 450), new Task(30, Set.of()), 1, new TimeWindow(200, 300)));
        Tour tour = CostModel.of(PlanningProblem.of(late, List.of(craft)))
                .plan(new int[][] {{0}})
                .tours()
                .get(0);

        assertThat(tour.stops().get(0).arrivesSeconds()).isCloseTo(125, CLOSE);
        assertThat(tour.stops().get(0).beginsSeconds()).isEqualTo(200);
        assertThat(tour.stops().get(0).leavesSeconds()).isEqualTo(230);
        assertThat(tour.stops().get(0).usedJoules()).isCloseTo(5_000 + 15_000 + 105 * 100, within(50.0));
    }

    @Test
    void measuresLengthsAsTheGlobeDoes() {
        Craft far = Craft.atHome(craft.id(), new Place(PlanningFixtures.point(0, 0), 0), PlanningFixtures.copter());
        Waypoint one = Waypoint.at("a", new Place(PlanningFixtures.point(60_000, 70_000), 100));
        Waypoint two = Waypoint.at("b", new Place(PlanningFixtures.point(-20_000, 90_000), 100));
        Legs legs = legs(PlanningProblem.of(List.of(one, two), List.of(far)));

        double globe = Geodesy.distanceMeters(one.place().point(), two.place().point());
        assertThat(legs.meters(0, 0, 1)).isCloseTo(globe, within(globe * 0.004));
    }

    @Test
    void buildsTenThousandWaypointsForAHundredDrones() {
        SplittableRandom random = new SplittableRandom(1);
        double[][] spots = new double[10_000][];
        for (int i = 0; i < spots.length; i++) {
            spots[i] = spot(random);
        }
        PlanningProblem problem = PlanningProblem.of(PlanningFixtures.waypoints(spots), PlanningFixtures.crafts(100));
        AllocationProblem instance = CostModel.of(problem).instance();

        assertThat(instance.visits()).hasSize(10_000);
    }
}
