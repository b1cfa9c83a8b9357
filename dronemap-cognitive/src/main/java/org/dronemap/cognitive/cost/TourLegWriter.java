package org.dronemap.cognitive.cost;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.cognitive.plan.TimedPlace;
import org.dronemap.cognitive.plan.TourLeg;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.core.geo.Geodetic;

/** Writes a leg of a plan fix by fix: take-off, turns round barriers, and landing. Never changes. */
final class TourLegWriter {
    private final PlanningProblem problem;
    private final PlaceTable track;
    private final DroneTypes fleet;
    private final Detours detours;

    TourLegWriter(PlanningProblem problem, PlaceTable track, DroneTypes fleet, Detours detours) {
        this.problem = problem;
        this.track = track;
        this.fleet = fleet;
        this.detours = detours;
    }

    TourLeg write(int drone, int from, int to, double departsSeconds) {
        int type = fleet.typeOf(drone);
        LegBuilder pen = new LegBuilder(fleet.paceOf(drone), place(from), departsSeconds);
        double leaves = track.leaves(from, to);
        double reaches = track.reaches(from, to);
        if (track.ground[from]) {
            pen.rise(leaves);
        }
        for (Geodetic turn : detours.between(type, from, to)) {
            pen.fly(new Place(turn, Math.max(leaves, reaches)));
        }
        pen.fly(place(to).at(reaches));
        if (track.ground[to]) {
            pen.land(track.altitude[to]);
        }
        return pen.way();
    }

    private Place place(int index) {
        if (index < track.waypoints) {
            return problem.waypoints().get(index).place();
        }
        int drone = (index - track.waypoints) / 2;
        boolean start = (index - track.waypoints) % 2 == 0;
        return start
                ? problem.crafts().get(drone).start().place()
                : problem.crafts().get(drone).finish().place();
    }

    /** Draws one way. Used once, by one thread. */
    private final class LegBuilder {
        private final FlightModel pace;
        private final List<TimedPlace> fixes = new ArrayList<>();
        private Place at;
        private double seconds;
        private double joules;

        LegBuilder(FlightModel pace, Place at, double seconds) {
            this.pace = pace;
            this.at = at;
            this.seconds = seconds;
            fixes.add(new TimedPlace(at, seconds));
        }

        void rise(double altitude) {
            double meters = altitude - at.altitudeAmslMeters();
            joules += pace.riseJoules(meters);
            reach(at.at(altitude), pace.riseSeconds(meters));
        }

        void land(double altitude) {
            double meters = at.altitudeAmslMeters() - altitude;
            joules += pace.landingJoules(meters);
            reach(at.at(altitude), pace.landingSeconds(meters));
        }

        void fly(Place next) {
            EquirectangularPlane chart = track.chart;
            double middle = (chart.stretch(at.point().latitudeDegrees())
                            + chart.stretch(next.point().latitudeDegrees()))
                    / 2;
            double east = (chart.x(next.point()) - chart.x(at.point())) * middle;
            double north = chart.trueNorth(next.point().latitudeDegrees())
                    - chart.trueNorth(at.point().latitudeDegrees());
            double up = next.altitudeAmslMeters() - at.altitudeAmslMeters();
            joules += pace.joules(east, north, up);
            reach(next, pace.seconds(east, north, up));
        }

        private void reach(Place next, double duration) {
            at = next;
            seconds += duration;
            fixes.add(new TimedPlace(at, seconds));
        }

        TourLeg way() {
            return new TourLeg(fixes, joules);
        }
    }
}
