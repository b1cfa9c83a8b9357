package org.dronemap.cognitive.plan;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.geo.LocalPlane;
import org.dronemap.core.geo.PlanePoint;

/** Checks one tour of a plan against its problem, and notes all faults. Used once, by one thread. */
final class TourCheck {
    private static final double SAME_METERS = 0.5;
    private static final double SAME_SECONDS = 1e-3;
    /** How far a duration or an energy may be off, as a share and on top of it. */
    private static final double SLACK = 0.01;

    /** By which share two ways of measuring lengths may differ where a battery is used to its last. */
    private static final double RANGE_SLACK = 1e-4;

    private static final double SLACK_SECONDS = 0.5;
    private static final double SLACK_JOULES = 200;

    private final PlanningProblem problem;
    private final Craft craft;
    private final Tour tour;
    private final ReferenceFlightModel flight;
    private final BarrierCheck fences;
    private final List<String> faults;
    private double joules;

    TourCheck(PlanningProblem problem, Craft craft, Tour tour, List<String> faults) {
        this.problem = problem;
        this.craft = craft;
        this.tour = tour;
        this.flight = new ReferenceFlightModel(craft, problem.wind());
        this.fences = new BarrierCheck(problem.barriers(), craft);
        this.faults = faults;
    }

    void judge(Map<String, Waypoint> waypoints) {
        Place at = craft.start().place();
        double free = craft.start().readySeconds();
        TourLeg first = tour.way(0);
        if (craft.start().airborne()) {
            joules += first.departsSeconds() * flight.hoverWatts();
        }
        if (!tour.stops().isEmpty() && !problem.trusts(craft)) {
            fault("has a link that is too bad to be given waypoints");
        }
        for (int i = 0; i < tour.stops().size(); i++) {
            TourStop stop = tour.stops().get(i);
            String words = "waypoint " + stop.waypoint();
            fly(stop.way(), at, free, "to " + words);
            Waypoint waypoint = waypoints.get(stop.waypoint());
            if (waypoint == null) {
                fault("visits " + stop.waypoint() + ", which is not asked for");
                return;
            }
            visit(stop, waypoint);
            at = waypoint.place();
            free = stop.leavesSeconds();
            joules += flight.hoverWatts() * (tour.way(i + 1).departsSeconds() - stop.arrivesSeconds());
        }
        fly(tour.last(), at, free, "to its end");
        expect(isSame(tour.last().to(), craft.finish().place()), "does not end where it must");
        ends();
    }

    private void visit(TourStop stop, Waypoint waypoint) {
        String words = "waypoint " + waypoint.id();
        expect(isSame(stop.way().to(), waypoint.place()), "does not come to " + words);
        expect(craft.can(waypoint.task()), "cannot do the task of " + words);
        expect(
                stop.beginsSeconds() >= stop.arrivesSeconds() - SAME_SECONDS,
                "begins at " + words + " before it is there");
        expect(
                stop.beginsSeconds() >= waypoint.window().opensSeconds() - SAME_SECONDS,
                "begins at " + words + " before its window opens");
        expect(
                stop.beginsSeconds() <= waypoint.window().closesSeconds() + SAME_SECONDS,
                "begins at " + words + " after its window has closed");
        expect(
                stop.leavesSeconds() >= stop.beginsSeconds() + waypoint.task().serviceSeconds() - SAME_SECONDS,
                "leaves " + words + " before its task is done");
        double used = joules + flight.hoverWatts() * (stop.leavesSeconds() - stop.arrivesSeconds());
        expect(isNear(stop.usedJoules(), used, SLACK_JOULES), energyWords(words, stop.usedJoules(), used));
    }

    private void ends() {
        expect(isNear(tour.usedJoules(), joules, SLACK_JOULES), energyWords("its end", tour.usedJoules(), joules));
        double range = craft.supply().rangeJoules();
        expect(
                joules <= range * (1 + RANGE_SLACK),
                String.format(Locale.ROOT, "draws %.1f Wh and may draw %.1f Wh", joules / 3_600, range / 3_600));
    }

    private void fly(TourLeg way, Place from, double free, String words) {
        expect(isSame(way.from(), from), "sets off " + words + " from where it is not");
        expect(way.departsSeconds() >= free - SAME_SECONDS, "sets off " + words + " before it is free to");
        int last = way.fixes().size() - 1;
        boolean rises = way.equals(tour.way(0)) && craft.beginsWithTakeOff();
        boolean lands = way.equals(tour.last()) && craft.lands();
        for (int i = 0; i < last; i++) {
            TimedPlace one = way.fixes().get(i);
            TimedPlace next = way.fixes().get(i + 1);
            if (rises && i == 0) {
                column(one, next, words);
                piece(one, next, flight.takeOff(one, next), words);
            } else if (lands && i + 1 == last) {
                column(next, one, words);
                piece(one, next, flight.landing(one, next), words);
            } else {
                piece(one, next, flight.cruise(one, next), words);
            }
            boolean column = (rises && i == 0) || (lands && i + 1 == last);
            fences.fault(one, next, column).ifPresent(what -> fault("on its way " + words + " " + what));
        }
    }

    private void column(TimedPlace ground, TimedPlace top, String words) {
        double height = top.place().altitudeAmslMeters() - ground.place().altitudeAmslMeters();
        expect(
                ReferenceFlightModel.isStraightUp(ground, top)
                        && height >= problem.rules().takeOffMeters() - SAME_METERS,
                "does not rise or land straight on its way " + words);
    }

    private void piece(TimedPlace one, TimedPlace next, ReferenceFlightModel.Effort effort, String words) {
        joules += effort.joules();
        double planned = next.seconds() - one.seconds();
        expect(
                isNear(planned, effort.seconds(), SLACK_SECONDS),
                String.format(
                        Locale.ROOT,
                        "takes %.1f s for a piece of its way %s that takes %.1f s",
                        planned,
                        words,
                        effort.seconds()));
    }

    private static String energyWords(String where, double planned, double own) {
        return String.format(
                Locale.ROOT, "has drawn %.1f Wh at %s and not %.1f Wh", own / 3_600, where, planned / 3_600);
    }

    private static boolean isNear(double planned, double own, double slack) {
        return Math.abs(planned - own) <= SLACK * own + slack;
    }

    private static boolean isSame(Place one, Place other) {
        PlanePoint gap = LocalPlane.offset(one.point(), other.point());
        return Math.hypot(gap.eastMeters(), gap.northMeters()) <= SAME_METERS
                && Math.abs(one.altitudeAmslMeters() - other.altitudeAmslMeters()) <= SAME_METERS;
    }

    private void expect(boolean holds, String otherwise) {
        if (!holds) {
            fault(otherwise);
        }
    }

    private void fault(String what) {
        faults.add("The drone " + craft.id() + " " + what + ".");
    }
}
