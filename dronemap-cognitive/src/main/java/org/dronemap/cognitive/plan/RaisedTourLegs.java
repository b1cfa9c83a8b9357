package org.dronemap.cognitive.plan;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.jspecify.annotations.Nullable;

/** Raises single legs of a planned tour, to keep drones apart: up at the leg's beginning, down at its end. */
final class RaisedTourLegs {
    private static final double HIGHEST_METERS = 9_000;
    /** How far heights may be off for the command gate. */
    private static final double HEIGHT_DOUBT_METERS = 0.6;
    /** Of the room beside barriers, since ways round them pass at just that room. */
    private static final double ROOM_SHARE = 0.9;

    private final Craft craft;
    private final Tour tour;
    private final ReferenceFlightModel flight;
    private final BarrierCheck fences;

    RaisedTourLegs(PlanningProblem problem, Craft craft, Tour tour) {
        this.craft = craft;
        this.tour = tour;
        this.flight = new ReferenceFlightModel(craft, problem.wind());
        this.fences = new BarrierCheck(
                problem.barriers(), craft, ROOM_SHARE * problem.rules().roomMeters());
    }

    double hoverWatts() {
        return flight.hoverWatts();
    }

    /** Null where zones do not allow it. */
    @Nullable
    TourLeg raised(int number, double meters) {
        TourLeg way = tour.way(number);
        return meters == 0
                ? way
                : isFree(number, meters - HEIGHT_DOUBT_METERS) && isFree(number, meters + HEIGHT_DOUBT_METERS)
                        ? write(number, meters)
                        : null;
    }

    private boolean rises(int number) {
        return number == 0 && craft.beginsWithTakeOff();
    }

    private boolean lands(int number) {
        return number == tour.stops().size() && craft.lands();
    }

    private List<TimedPlace> fixes(int number, double meters) {
        List<TimedPlace> flat = tour.way(number).fixes();
        List<TimedPlace> fixes = new ArrayList<>(flat.size() + 2);
        for (int i = 0; i < flat.size(); i++) {
            TimedPlace fix = flat.get(i);
            boolean first = i == 0;
            boolean last = i == flat.size() - 1;
            TimedPlace above = new TimedPlace(fix.place().at(fix.place().altitudeAmslMeters() + meters), fix.seconds());
            if (first) {
                fixes.add(fix);
            }
            if (!(first && rises(number)) && !(last && lands(number))) {
                fixes.add(above);
            }
            if (last) {
                fixes.add(fix);
            }
        }
        return fixes;
    }

    private boolean isFree(int number, double meters) {
        List<TimedPlace> fixes = fixes(number, meters);
        for (int i = 0; i + 1 < fixes.size(); i++) {
            boolean column = (i == 0 && rises(number)) || (i + 2 == fixes.size() && lands(number));
            TimedPlace one = fixes.get(i);
            TimedPlace next = fixes.get(i + 1);
            if (Math.max(one.place().altitudeAmslMeters(), next.place().altitudeAmslMeters()) > HIGHEST_METERS
                    || fences.fault(one, next, column).isPresent()) {
                return false;
            }
        }
        return true;
    }

    private TourLeg write(int number, double meters) {
        List<TimedPlace> fixes = fixes(number, meters);
        List<TimedPlace> timed = new ArrayList<>(fixes.size());
        double seconds = tour.way(number).departsSeconds();
        double joules = 0;
        timed.add(new TimedPlace(fixes.get(0).place(), seconds));
        for (int i = 0; i + 1 < fixes.size(); i++) {
            TimedPlace one = fixes.get(i);
            TimedPlace next = fixes.get(i + 1);
            ReferenceFlightModel.Effort effort = i == 0 && rises(number)
                    ? flight.takeOff(one, next)
                    : i + 2 == fixes.size() && lands(number) ? flight.landing(one, next) : flight.cruise(one, next);
            seconds += effort.seconds();
            joules += effort.joules();
            timed.add(new TimedPlace(next.place(), seconds));
        }
        return new TourLeg(timed, joules);
    }
}
