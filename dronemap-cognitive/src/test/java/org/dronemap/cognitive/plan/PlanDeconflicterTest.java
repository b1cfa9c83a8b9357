package org.dronemap.cognitive.plan;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.cost.CostModel;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.EnergyBudget;
import org.dronemap.cognitive.problem.Finish;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Start;
import org.dronemap.cognitive.problem.Task;
import org.dronemap.cognitive.problem.TimeWindow;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.zone.AltitudeBand;
import org.junit.jupiter.api.Test;

/** Drones are kept apart by waiting and by layers, and a plain walk through time finds nothing to object. */
class PlanDeconflicterTest {
    private static DeconflictedPlan arranged(PlanningProblem problem, int[][] orders) {
        return PlanDeconflicter.deconflict(problem, CostModel.of(problem).plan(orders));
    }

    private static void isRight(PlanningProblem problem, DeconflictedPlan arranged) {
        assertThat(arranged.conflicts()).isEmpty();
        assertThat(PlanChecker.faults(problem, arranged.plan())).isEmpty();
        assertThat(nearest(problem, arranged.plan())).isGreaterThanOrEqualTo(1);
    }

    /** The least distance in shares of what is asked for, looked at every tenth of a second as the crow flies. */
    private static double nearest(PlanningProblem problem, Plan plan) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < plan.tours().size(); i++) {
            for (int j = i + 1; j < plan.tours().size(); j++) {
                for (double t = 0; t < plan.endsSeconds(); t += 0.1) {
                    Place one = at(problem, plan.tours().get(i), t);
                    Place other = at(problem, plan.tours().get(j), t);
                    if (one != null && other != null) {
                        double flat = Geodesy.distanceMeters(one.point(), other.point());
                        double high = Math.abs(one.altitudeAmslMeters() - other.altitudeAmslMeters());
                        least = Math.min(least, Math.max(flat / 9.9, high / 4.95));
                    }
                }
            }
        }
        return least;
    }

    /** At constant speed between fixes; null while it is on the ground. */
    private static Place at(PlanningProblem problem, Tour tour, double seconds) {
        Craft craft = problem.crafts().stream()
                .filter(one -> one.id().equals(tour.drone()))
                .findFirst()
                .orElseThrow();
        if ((!craft.start().airborne() && seconds < tour.departsSeconds())
                || (craft.lands() && seconds > tour.endsSeconds())) {
            return null;
        }
        Place place = craft.start().place();
        for (TourLeg way : tour.ways()) {
            for (int i = 0; i + 1 < way.fixes().size(); i++) {
                TimedPlace one = way.fixes().get(i);
                TimedPlace next = way.fixes().get(i + 1);
                if (seconds >= next.seconds()) {
                    place = next.place();
                } else if (seconds > one.seconds()) {
                    double share = (seconds - one.seconds()) / (next.seconds() - one.seconds());
                    return between(one.place(), next.place(), share);
                }
            }
        }
        return place;
    }

    private static Place between(Place one, Place other, double share) {
        return new Place(
                new Geodetic(
                        one.point().latitudeDegrees()
                                + share
                                        * (other.point().latitudeDegrees()
                                                - one.point().latitudeDegrees()),
                        one.point().longitudeDegrees()
                                + share
                                        * (other.point().longitudeDegrees()
                                                - one.point().longitudeDegrees())),
                one.altitudeAmslMeters() + share * (other.altitudeAmslMeters() - one.altitudeAmslMeters()));
    }

    @Test
    void staggersTakeOffAndLandingOnOnePad() {
        List<Waypoint> waypoints =
                PlanningFixtures.waypoints(new double[] {0, 500}, new double[] {500, 0}, new double[] {-500, 0});
        PlanningProblem problem = PlanningProblem.of(
                waypoints,
                List.of(
                        PlanningFixtures.craft(0, 0, 0),
                        PlanningFixtures.craft(1, 0, 0),
                        PlanningFixtures.craft(2, 0, 0)));

        DeconflictedPlan arranged = arranged(problem, new int[][] {{0}, {1}, {2}});

        isRight(problem, arranged);
        assertThat(arranged.plan().tours())
                .extracting(Tour::departsSeconds)
                .doesNotHaveDuplicates()
                .contains(0.0);
    }

    @Test
    void leadsDronesPastEachOtherInTheAir() {
        Craft one = PlanningFixtures.craft(0, 0, 0)
                .with(Start.inFlight(PlanningFixtures.place(-300, 0, 450)))
                .with(Finish.hovering(PlanningFixtures.place(300, 0, 450)));
        Craft other = PlanningFixtures.craft(1, 0, 0)
                .with(Start.inFlight(PlanningFixtures.place(300, 30, 450)))
                .with(Finish.hovering(PlanningFixtures.place(-300, -30, 450)));
        PlanningProblem problem = PlanningProblem.of(List.of(), List.of(one, other));

        DeconflictedPlan arranged = arranged(problem, new int[][] {{}, {}});

        isRight(problem, arranged);
        assertThat(arranged.plan().endsSeconds()).isLessThan(100);
    }

    @Test
    void takesNoLayerThatAZoneForbids() {
        Craft one = PlanningFixtures.craft(0, 0, 0)
                .with(Start.inFlight(PlanningFixtures.place(-300, 0, 450)))
                .with(Finish.hovering(PlanningFixtures.place(300, 0, 450)));
        Craft other = PlanningFixtures.craft(1, 0, 0)
                .with(Start.inFlight(PlanningFixtures.place(300, 0, 450)))
                .with(Finish.hovering(PlanningFixtures.place(-300, 0, 450)));
        Barrier lid = new Barrier(
                "the lid",
                new FenceArea.Circle(false, PlanningFixtures.point(0, 0), 100),
                new AltitudeBand(455.0, null, Altitude.Reference.AMSL),
                Set.of());
        PlanningProblem free = PlanningProblem.of(List.of(), List.of(one, other));
        PlanningProblem lidded = free.withBarriers(List.of(lid));

        isRight(free, arranged(free, new int[][] {{}, {}}));
        assertThat(arranged(lidded, new int[][] {{}, {}}).conflicts()).hasSize(1);
    }

    @Test
    void neitherMissesAWindowNorEmptiesABattery() {
        List<Waypoint> waypoints = List.of(
                new Waypoint("now", PlanningFixtures.place(0, 500, 450), Task.FLY_THROUGH, 1, new TimeWindow(0, 76)),
                Waypoint.at("any", PlanningFixtures.place(0, 900, 450)));
        Craft hurried = PlanningFixtures.craft(0, 0, 0);
        PlanningProblem problem = PlanningProblem.of(waypoints, List.of(hurried, PlanningFixtures.craft(1, 0, 0)));
        isRight(problem, arranged(problem, new int[][] {{0}, {1}}));

        Craft empty = PlanningFixtures.craft(1, 0, 0).with(new EnergyBudget(1, 0));
        PlanningProblem drained = PlanningProblem.of(waypoints, List.of(hurried, empty));
        assertThat(arranged(drained, new int[][] {{0}, {1}})
                        .plan()
                        .tours()
                        .get(1)
                        .usedJoules())
                .as("as planned: no passage draws less than what it may")
                .isEqualTo(CostModel.of(drained)
                        .plan(new int[][] {{0}, {1}})
                        .tours()
                        .get(1)
                        .usedJoules());
    }

    @Test
    void keepsTwentyRandomCrowdsApart() {
        SplittableRandom random = new SplittableRandom(17);
        for (int round = 0; round < 20; round++) {
            PlanningProblem problem = crowd(random, 6, 30);
            int[][] orders = new int[6][5];
            for (int i = 0; i < 30; i++) {
                orders[i % 6][i / 6] = i;
            }
            Plan before = CostModel.of(problem).plan(orders);
            DeconflictedPlan arranged = PlanDeconflicter.deconflict(problem, before);

            isRight(problem, arranged);
            assertThat(arranged.plan().endsSeconds()).isLessThan(before.endsSeconds() * 1.5 + 60);
        }
    }

    private static PlanningProblem crowd(SplittableRandom random, int drones, int waypoints) {
        List<Waypoint> all = new ArrayList<>();
        for (int i = 0; i < waypoints; i++) {
            double x = 40 * (i % 6) + random.nextDouble(-10, 10);
            double y = 100 + 40 * Math.floorDiv(i, 6) + random.nextDouble(-10, 10);
            all.add(new Waypoint(
                    "w" + i,
                    PlanningFixtures.place(x, y, random.nextDouble(430, 440)),
                    new Task(random.nextInt(10), Set.of()),
                    1,
                    TimeWindow.ALWAYS));
        }
        List<Craft> crafts = new ArrayList<>();
        for (int i = 0; i < drones; i++) {
            Craft craft = PlanningFixtures.craft(i, 12 * i, 0);
            crafts.add(i % 3 == 0 ? craft.with(Start.inFlight(PlanningFixtures.place(30 * i, 50, 435))) : craft);
        }
        return PlanningProblem.of(all, crafts);
    }
}
