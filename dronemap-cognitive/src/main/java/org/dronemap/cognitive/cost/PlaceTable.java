package org.dronemap.cognitive.cost;

import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.PlanningProblem;

/**
 * Coordinates of all places of a problem, numbered as in {@link Legs}. Never changes.
 *
 * <p>The way between two places is taken east by the mean of their parallels and north along the meridian, which is
 * right within 1 in 100,000 up to 100 km.
 */
final class PlaceTable {
    final int waypoints;
    final int places;
    final double takeOffMeters;
    final EquirectangularPlane chart;
    /** On the chart. */
    final double[] x;

    final double[] y;
    /** The chart's x times this is metres. */
    final double[] stretch;
    /** Metres. */
    final double[] north;

    final double[] altitude;
    /** Taken off from, or landed on. */
    final boolean[] ground;

    PlaceTable(PlanningProblem problem) {
        this.waypoints = problem.waypoints().size();
        this.places = waypoints + 2 * problem.crafts().size();
        this.takeOffMeters = problem.rules().takeOffMeters();
        this.chart =
                new EquirectangularPlane(problem.crafts().get(0).start().place().point());
        this.x = new double[places];
        this.y = new double[places];
        this.stretch = new double[places];
        this.north = new double[places];
        this.altitude = new double[places];
        this.ground = new boolean[places];
        for (int i = 0; i < waypoints; i++) {
            set(i, problem.waypoints().get(i).place(), false);
        }
        for (int r = 0; r < problem.crafts().size(); r++) {
            Craft craft = problem.crafts().get(r);
            set(waypoints + 2 * r, craft.start().place(), craft.beginsWithTakeOff());
            set(waypoints + 2 * r + 1, craft.finish().place(), craft.lands());
        }
    }

    double steepestDegrees() {
        double steepest = 0;
        for (int i = 0; i < places; i++) {
            steepest = Math.max(steepest, Math.abs(chart.point(0, y[i]).latitudeDegrees()));
        }
        return steepest;
    }

    /** From corner to corner of the box around all places. */
    double extentMeters() {
        double[] box = {x[0], x[0], y[0], y[0]};
        for (int i = 1; i < places; i++) {
            box[0] = Math.min(box[0], x[i]);
            box[1] = Math.max(box[1], x[i]);
            box[2] = Math.min(box[2], y[i]);
            box[3] = Math.max(box[3], y[i]);
        }
        return Math.hypot(box[1] - box[0], box[3] - box[2]);
    }

    private void set(int index, Place place, boolean onGround) {
        double latitude = place.point().latitudeDegrees();
        x[index] = chart.x(place.point());
        y[index] = chart.y(place.point());
        stretch[index] = chart.stretch(latitude);
        north[index] = chart.trueNorth(latitude);
        altitude[index] = place.altitudeAmslMeters();
        ground[index] = onGround;
    }

    double east(int from, int to) {
        return (x[to] - x[from]) * (stretch[from] + stretch[to]) * 0.5;
    }

    double north(int from, int to) {
        return north[to] - north[from];
    }

    /** How high a leg begins: after the take-off, if that is where it begins. */
    double leaves(int from, int to) {
        return ground[from] ? Math.max(lowest(to), lowest(from)) : altitude[from];
    }

    /** How high a leg ends: before the landing, if that is where it ends. */
    double reaches(int from, int to) {
        return ground[to] ? Math.max(lowest(from), lowest(to)) : altitude[to];
    }

    private double lowest(int place) {
        return ground[place] ? altitude[place] + takeOffMeters : altitude[place];
    }
}
