package org.dronemap.cognitive.plan;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.UnaryOperator;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.cost.CostModel;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.EnergyBudget;
import org.dronemap.cognitive.problem.Finish;
import org.dronemap.cognitive.problem.Objective;
import org.dronemap.cognitive.problem.Performance;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Skill;
import org.dronemap.cognitive.problem.Start;
import org.dronemap.cognitive.problem.Task;
import org.dronemap.cognitive.problem.TimeWindow;
import org.dronemap.cognitive.problem.UniformWind;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.separation.Separation;
import org.dronemap.core.zone.AltitudeBand;
import org.junit.jupiter.api.Test;

/** Every kind of fault is planted once in a plan that is right, and found. */
class PlanCheckerTest {
    private static final Task PICTURE = new Task(5, Set.of(new Skill("take a picture")));

    private final Craft north =
            PlanningFixtures.craft(0, 0, 0).withSkills(PICTURE.needs()).with(EnergyBudget.ofWattHours(100, 20));
    private final Craft south = PlanningFixtures.craft(1, 0, -500);
    private final List<Waypoint> waypoints = List.of(
            new Waypoint("photo", PlanningFixtures.place(0, 1000, 450), PICTURE, 1, new TimeWindow(200, 400)),
            Waypoint.at("second", PlanningFixtures.place(1000, 1000, 450)),
            Waypoint.at("third", PlanningFixtures.place(1000, -500, 450)));
    private final PlanningProblem problem =
            PlanningProblem.of(waypoints, List.of(north, south)).with(new UniformWind(4, 30));
    private final Plan right = CostModel.of(problem).plan(new int[][] {{0, 1}, {2}});

    @Test
    void findsNothingInAPlanThatIsRight() {
        assertThat(PlanChecker.faults(problem, right)).isEmpty();
        assertThat(right.tours()).hasSize(2);
    }

    @Test
    void findsNothingInPlansOfManyKindsOfDronesInAnyWind() {
        SplittableRandom random = new SplittableRandom(11);
        for (int round = 0; round < 300; round++) {
            PlanningProblem any = anyProblem(random);
            Plan plan = CostModel.of(any).plan(new int[][] {{3, 1}, {0, 2}});

            assertThat(PlanChecker.faults(any, plan)).as("round " + round).isEmpty();
        }
    }

    private static PlanningProblem anyProblem(SplittableRandom random) {
        List<Waypoint> waypoints = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
            waypoints.add(Waypoint.at("w" + i, anyPlace(random)));
        }
        VehicleKind[] kinds = VehicleKind.values();
        Craft one = PlanningFixtures.craft(0, 0, 0)
                .with(Performance.of(kinds[random.nextInt(kinds.length)]))
                .with(new Start(anyPlace(random), random.nextBoolean(), random.nextDouble(30)));
        Craft two = PlanningFixtures.craft(1, -9_000, 0)
                .with(Finish.hovering(anyPlace(random)))
                .with(random.nextBoolean() ? PlanningFixtures.copter() : PlanningFixtures.aeroplane());
        // far apart in height or not: keeping drones apart is not what is looked at here
        return PlanningProblem.of(waypoints, List.of(one, two))
                .with(new UniformWind(random.nextDouble(4), random.nextDouble(360)))
                .with(new org.dronemap.cognitive.problem.PlanningRules(new Separation(0, 0), 0.5, 3, 5));
    }

    private static Place anyPlace(SplittableRandom random) {
        return PlanningFixtures.place(
                random.nextDouble(-20_000, 20_000), random.nextDouble(-20_000, 20_000), random.nextDouble(400, 600));
    }

    private void finds(String fault, PlanningProblem planned, Plan plan) {
        assertThat(PlanChecker.faults(planned, plan))
                .anySatisfy(found -> assertThat(found).contains(fault));
    }

    /** With the first drone's tour changed. */
    private Plan changed(UnaryOperator<Tour> change) {
        return new Plan(
                List.of(change.apply(right.tours().get(0)), right.tours().get(1)), right.unserved());
    }

    private Plan changedStop(int index, UnaryOperator<TourStop> change) {
        return changed(tour -> {
            List<TourStop> stops = new ArrayList<>(tour.stops());
            stops.set(index, change.apply(stops.get(index)));
            return new Tour(tour.drone(), stops, tour.last(), tour.usedJoules());
        });
    }

    @Test
    void findsWaypointsThatAreForgottenDoubledOrUnknown() {
        Tour first = right.tours().get(0);
        Tour second = right.tours().get(1);

        finds("waypoint third is neither visited nor unserved", problem, new Plan(List.of(first), List.of()));
        finds(
                "waypoint photo is both visited and unserved",
                problem,
                new Plan(right.tours(), List.of(new UnservedWaypoint("photo", "no"))));
        finds(
                "waypoint third is unserved without a reason",
                problem,
                new Plan(List.of(first), List.of(new UnservedWaypoint("third", " "))));
        finds(
                "waypoint nowhere is not part of the problem",
                problem,
                new Plan(right.tours(), List.of(new UnservedWaypoint("nowhere", "no"))));
        finds("waypoint third is visited twice", problem, CostModel.of(problem).plan(new int[][] {{0, 1}, {2, 2}}));
        finds("has two tours", problem, new Plan(List.of(first, second, second), List.of()));
        finds(
                "is not part of the problem",
                PlanningProblem.of(waypoints, List.of(north)).with(problem.wind()),
                right);
    }

    @Test
    void findsADroneThatCannotDoTheTaskOrWhoseLinkIsBad() {
        finds(
                "The drone d1 cannot do the task of waypoint photo",
                problem,
                CostModel.of(problem).plan(new int[][] {{1}, {2, 0}}));
        PlanningProblem bad = PlanningProblem.of(waypoints, List.of(north.withLinkQuality(0.1), south));
        finds("has a link that is too bad", bad, CostModel.of(bad).plan(new int[][] {{0, 1}, {2}}));
    }

    @Test
    void findsBrokenWindowsAndTasksCutShort() {
        finds("before its window opens", problem, changedStop(0, stop -> times(stop, 150, 205)));
        finds("after its window has closed", problem, changedStop(0, stop -> times(stop, 401, 410)));
        finds("before its task is done", problem, changedStop(0, stop -> times(stop, 200, 201)));
        finds("before it is there", problem, changedStop(1, stop -> times(stop, 100, 400)));
        finds("before it is free to", problem, changedStop(0, stop -> times(stop, 200, 230)));
    }

    private static TourStop times(TourStop stop, double begins, double leaves) {
        return new TourStop(stop.waypoint(), stop.way(), begins, leaves, stop.usedJoules());
    }

    @Test
    void findsDronesThatAreTooQuickOrDrawTooLittle() {
        finds(
                "for a piece of its way",
                problem,
                changedStop(
                        1,
                        stop -> new TourStop(
                                stop.waypoint(),
                                sooner(stop.way(), 5),
                                stop.beginsSeconds(),
                                stop.leavesSeconds(),
                                stop.usedJoules())));
        finds(
                "at its end and not",
                problem,
                changed(tour -> new Tour(tour.drone(), tour.stops(), tour.last(), tour.usedJoules() * 0.97)));
        finds(
                "at waypoint second and not",
                problem,
                changedStop(
                        1,
                        stop -> new TourStop(
                                stop.waypoint(),
                                stop.way(),
                                stop.beginsSeconds(),
                                stop.leavesSeconds(),
                                stop.usedJoules() * 1.1)));
        PlanningProblem empty = PlanningProblem.of(
                        waypoints, List.of(north.with(EnergyBudget.ofWattHours(35, 20)), south))
                .with(problem.wind());
        finds("and may draw 15.0 Wh", empty, right);
    }

    private static TourLeg sooner(TourLeg way, double seconds) {
        List<TimedPlace> fixes = new ArrayList<>(way.fixes());
        TimedPlace last = fixes.remove(fixes.size() - 1);
        fixes.add(new TimedPlace(last.place(), last.seconds() - seconds));
        return new TourLeg(fixes, way.joules());
    }

    @Test
    void findsWaysThatDoNotHangTogether() {
        TourLeg elsewhere = right.tours().get(1).last();
        finds(
                "does not end where it must",
                problem,
                changed(tour -> new Tour(tour.drone(), tour.stops(), elsewhere, tour.usedJoules())));
        finds(
                "from where it is not",
                problem,
                changed(tour -> new Tour(tour.drone(), tour.stops(), elsewhere, tour.usedJoules())));
        finds(
                "does not come to waypoint second",
                problem,
                changedStop(
                        1,
                        stop -> new TourStop(
                                stop.waypoint(),
                                elsewhere,
                                stop.beginsSeconds(),
                                stop.leavesSeconds(),
                                stop.usedJoules())));
        finds(
                "does not rise or land straight",
                problem,
                changedStop(
                        0,
                        stop -> new TourStop(
                                stop.waypoint(),
                                new TourLeg(
                                        List.of(
                                                stop.way().fixes().get(0),
                                                stop.way().fixes().get(2)),
                                        1),
                                stop.beginsSeconds(),
                                stop.leavesSeconds(),
                                stop.usedJoules())));
    }

    @Test
    void findsDronesThatAreLeftInTheAirOrIdle() {
        Craft flying = south.with(Start.inFlight(PlanningFixtures.place(0, -500, 430)));
        Plan alone = CostModel.of(problem).plan(new int[][] {{0, 1, 2}, {}});

        finds("d1 is in the air and has no tour", PlanningProblem.of(waypoints, List.of(north, flying)), alone);
        finds("d1 visits nothing", problem.with(new Objective(1, Objective.Measure.SECONDS, 0, true)), alone);
    }

    @Test
    void findsWaysThroughZones() {
        FenceArea box = box(false, 400, 900, 600, 1100);
        finds("leads through the moor", fenced(box, AltitudeBand.ALL), right);
        finds(
                "leads through the moor",
                fenced(new FenceArea.Circle(false, PlanningFixtures.point(500, 1040), 50), AltitudeBand.ALL),
                right);
        finds("leads through the moor", fenced(box, amsl(440, 460)), right);
        finds("leads through the moor", fenced(box(false, -50, -50, 50, 50), amsl(440, 460)), right);
        finds("leaves the moor", fenced(box(true, -2000, -2000, 900, 2000), AltitudeBand.ALL), right);
        finds(
                "leaves the moor",
                fenced(new FenceArea.Circle(true, PlanningFixtures.point(0, 0), 1200), AltitudeBand.ALL),
                right);
        finds("over the ceiling", fenced(box(true, -2000, -2000, 2000, 2000), amsl(null, 449)), right);
        assertThat(PlanChecker.faults(fenced(box, amsl(451, null)), right)).isEmpty();
        assertThat(PlanChecker.faults(fenced(box, amsl(null, 449)), right)).isEmpty();
        assertThat(PlanChecker.faults(fenced(box(true, -2000, -2000, 2000, 2000), amsl(null, 451)), right))
                .isEmpty();
        assertThat(PlanChecker.faults(
                        problem.withBarriers(
                                List.of(new Barrier("the moor", box, AltitudeBand.ALL, Set.of(new DroneId("d1"))))),
                        right))
                .as("binds the other drone")
                .isEmpty();
    }

    private PlanningProblem fenced(FenceArea shape, AltitudeBand band) {
        return problem.withBarriers(List.of(new Barrier("the moor", shape, band, Set.of())));
    }

    private static AltitudeBand amsl(Integer floor, Integer ceiling) {
        return new AltitudeBand(
                floor == null ? null : Double.valueOf(floor),
                ceiling == null ? null : Double.valueOf(ceiling),
                Altitude.Reference.AMSL);
    }

    private static FenceArea box(boolean inside, double west, double south, double east, double north) {
        return new FenceArea.Polygon(
                inside,
                List.of(
                        PlanningFixtures.point(west, south),
                        PlanningFixtures.point(east, south),
                        PlanningFixtures.point(east, north),
                        PlanningFixtures.point(west, north)));
    }

    @Test
    void findsDronesThatComeTooNear() {
        Craft beside = PlanningFixtures.craft(2, 0, 2000);
        List<Waypoint> across = List.of(
                Waypoint.at("a", PlanningFixtures.place(0, 1500, 450)),
                Waypoint.at("b", PlanningFixtures.place(0, 500, 450)));
        PlanningProblem opposed = PlanningProblem.of(across, List.of(north, beside));

        finds(
                "The drones d0 and d2 are 10.0 m apart",
                opposed,
                CostModel.of(opposed).plan(new int[][] {{0}, {1}}));
        PlanningProblem stacked = PlanningProblem.of(
                List.of(across.get(0), Waypoint.at("b", PlanningFixtures.place(0, 500, 456))),
                List.of(north, beside.with(Finish.hovering(PlanningFixtures.place(0, 500, 456)))));
        assertThat(SeparationCheck.conflicts(stacked, CostModel.of(stacked).plan(new int[][] {{0}, {1}})))
                .as("6 m over each other, and 500 m apart when one comes down")
                .isEmpty();
    }
}
