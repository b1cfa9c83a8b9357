package org.dronemap.cognitive.plan;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.stored.Stored;

/**
 * One drone's tour: its stops in order, the leg to its end, and the energy it draws.
 *
 * @param last from the last stop, or from the start, to the drone's end
 * @param usedJoules drawn in all
 */
@Stored(names = "drone stops last usedJoules")
public record Tour(DroneId drone, List<TourStop> stops, TourLeg last, double usedJoules) {
    public Tour {
        stops = List.copyOf(stops);
    }

    /** One more than there are stops. */
    public List<TourLeg> ways() {
        List<TourLeg> ways = new ArrayList<>(stops.size() + 1);
        stops.forEach(stop -> ways.add(stop.way()));
        ways.add(last);
        return ways;
    }

    /** To the stop with that number, or to the end when it is their count. */
    public TourLeg way(int stop) {
        return stop < stops.size() ? stops.get(stop).way() : last;
    }

    public double departsSeconds() {
        return way(0).departsSeconds();
    }

    public double endsSeconds() {
        return last.arrivesSeconds();
    }
}
