package org.dronemap.cognitive.operation.run;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.dronemap.cognitive.plan.MissionWriter;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.mission.Mission;

/**
 * What one drone is given to fly.
 *
 * @param tour on a clock whose zero is {@code zero}
 * @param arrivals for each stop of the tour the number of the mission's item that is behind the drone when it is done
 */
public record Sortie(Tour tour, Mission mission, List<Integer> arrivals, Instant zero) {
    private static final double NANOS = 1e9;

    public Sortie {
        arrivals = List.copyOf(arrivals);
    }

    /** {@code craft}: as it stands in the problem that the tour was made for. */
    static Sortie of(Craft craft, VehicleKind kind, Tour tour, Instant zero) {
        MissionWriter.Written written = new MissionWriter(craft, kind).write(tour);
        return new Sortie(tour, new Mission(written.items()), written.arrivals(), zero);
    }

    /** Which waypoints are done when so many items are behind the drone. */
    List<String> done(int passed) {
        int stops = (int) arrivals.stream().filter(item -> item < passed).count();
        return tour.stops().subList(0, stops).stream()
                .map(stop -> stop.waypoint())
                .toList();
    }

    /** When it is to be there; empty: it is none of its stops. */
    Optional<Instant> due(String waypoint) {
        return tour.stops().stream()
                .filter(stop -> stop.waypoint().equals(waypoint))
                .findFirst()
                .map(stop -> moment(stop.arrivesSeconds()));
    }

    Instant moment(double seconds) {
        return zero.plusNanos((long) (seconds * NANOS));
    }
}
