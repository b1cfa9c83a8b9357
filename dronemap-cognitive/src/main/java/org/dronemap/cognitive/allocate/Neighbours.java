package org.dronemap.cognitive.allocate;

import java.util.Arrays;
import java.util.stream.IntStream;

/** Of each waypoint the others that are nearest by time, nearest first. Immutable. */
final class Neighbours {
    private final int[] lists;
    private final int length;

    Neighbours(Costs costs, int waypoints, int most) {
        length = Math.min(most, Math.max(0, waypoints - 1));
        lists = new int[waypoints * length];
        IntStream.range(0, waypoints).parallel().forEach(i -> fill(costs, waypoints, i));
    }

    private void fill(Costs costs, int waypoints, int i) {
        double[] nearest = new double[length];
        int[] which = new int[length];
        int count = 0;
        for (int j = 0; j < waypoints; j++) {
            if (j == i) {
                continue;
            }
            double seconds = costs.seconds(0, i, j) + costs.seconds(0, j, i);
            if (count == length && seconds >= nearest[length - 1]) {
                continue;
            }
            int at = count < length ? count++ : length - 1;
            while (at > 0 && nearest[at - 1] > seconds) {
                nearest[at] = nearest[at - 1];
                which[at] = which[at - 1];
                at--;
            }
            nearest[at] = seconds;
            which[at] = j;
        }
        System.arraycopy(which, 0, lists, i * length, length);
    }

    int length() {
        return length;
    }

    int get(int waypoint, int rank) {
        return lists[waypoint * length + rank];
    }

    int[] of(int waypoint) {
        return Arrays.copyOfRange(lists, waypoint * length, (waypoint + 1) * length);
    }
}
