package org.dronemap.cognitive.allocate;

import java.util.Arrays;
import java.util.Comparator;
import java.util.stream.IntStream;
import org.dronemap.cognitive.cost.Legs;

/**
 * For each waypoint the waypoints near it, likely neighbours in a tour first, so that the search tries few places.
 * Where waypoints lie in clusters all that are nearest are in the same one; therefore the nearest of each quarter of
 * the compass are among the first. Immutable.
 */
final class NeighbourLists {
    /** How many come first. */
    static final int CLOSE = 16;

    private static final int NEAREST = 40;

    private final int[] lists;
    private final int length;

    NeighbourLists(Legs legs, int waypoints) {
        length = Math.min(NEAREST, Math.max(0, waypoints - 1));
        lists = new int[waypoints * length];
        double[] east =
                IntStream.range(0, waypoints).mapToDouble(legs::eastMeters).toArray();
        double[] north =
                IntStream.range(0, waypoints).mapToDouble(legs::northMeters).toArray();
        int[] eastward = IntStream.range(0, waypoints)
                .boxed()
                .sorted(Comparator.comparingDouble(waypoint -> east[waypoint]))
                .mapToInt(Integer::intValue)
                .toArray();
        IntStream.range(0, waypoints).parallel().forEach(at -> {
            int waypoint = eastward[at];
            int[] list = new NeighbourFinder(east, north, waypoint, length).look(eastward, at);
            System.arraycopy(list, 0, lists, waypoint * length, length);
        });
    }

    int length() {
        return length;
    }

    /** By rank: before {@link #CLOSE} the likely ones, after it the rest, each part nearest first. */
    int get(int waypoint, int rank) {
        return lists[waypoint * length + rank];
    }

    int[] of(int waypoint) {
        return Arrays.copyOfRange(lists, waypoint * length, (waypoint + 1) * length);
    }
}
