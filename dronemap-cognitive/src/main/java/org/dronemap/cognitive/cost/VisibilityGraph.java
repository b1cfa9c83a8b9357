package org.dronemap.cognitive.cost;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;
import java.util.concurrent.atomic.AtomicReferenceArray;
import org.jspecify.annotations.Nullable;

/**
 * Visibility graph of the barriers that stand at certain heights: finds the shortest paths round them. What is seen
 * from where is found out when it is first asked for. Safe for several threads.
 */
final class VisibilityGraph {
    private final List<ChartBarrier> blocks;
    private final ProjectionError bend;
    private final double[] x;
    private final double[] y;
    private final AtomicReferenceArray<int[]> seen;

    VisibilityGraph(List<ChartBarrier> blocks, ProjectionError bend, double[] rooms) {
        this.blocks = List.copyOf(blocks);
        this.bend = bend;
        List<double[]> turns = new ArrayList<>();
        for (double room : rooms) {
            blocks.forEach(block -> block.turns(room, (atX, atY) -> isFree(atX, atY, atX, atY), turns));
        }
        turns.removeIf(turn -> !isFree(turn[0], turn[1], turn[0], turn[1]));
        this.x = turns.stream().mapToDouble(turn -> turn[0]).toArray();
        this.y = turns.stream().mapToDouble(turn -> turn[1]).toArray();
        this.seen = new AtomicReferenceArray<>(x.length);
    }

    int turns() {
        return x.length;
    }

    double x(int turn) {
        return x[turn];
    }

    double y(int turn) {
        return y[turn];
    }

    boolean isFree(double x1, double y1, double x2, double y2) {
        double room = bend.room(Math.hypot(x2 - x1, y2 - y1));
        for (ChartBarrier block : blocks) {
            if (!block.isFree(x1, y1, x2, y2, room)) {
                return false;
            }
        }
        return true;
    }

    /** The turns that are seen from a place. */
    int[] seenFrom(double fromX, double fromY) {
        int[] found = new int[x.length];
        int count = 0;
        for (int i = 0; i < x.length; i++) {
            if (isFree(fromX, fromY, x[i], y[i])) {
                found[count++] = i;
            }
        }
        return Arrays.copyOf(found, count);
    }

    private int[] seenFrom(int turn) {
        int[] known = seen.get(turn);
        if (known == null) {
            known = seenFrom(x[turn], y[turn]);
            seen.set(turn, known);
        }
        return known;
    }

    /** The shortest ways from one place to all turns. */
    final class ShortestPathTree {
        private final double[] meters = new double[x.length];
        private final int[] before = new int[x.length];

        ShortestPathTree(double fromX, double fromY, int[] first) {
            Arrays.fill(meters, Double.POSITIVE_INFINITY);
            Arrays.fill(before, -1);
            PriorityQueue<QueueEntry> next = new PriorityQueue<>(Comparator.comparingDouble(QueueEntry::meters));
            for (int turn : first) {
                meters[turn] = Math.hypot(x[turn] - fromX, y[turn] - fromY);
                next.add(new QueueEntry(turn, meters[turn]));
            }
            for (QueueEntry at = next.poll(); at != null; at = next.poll()) {
                if (at.meters() == meters[at.turn()]) {
                    spread(at.turn(), next);
                }
            }
        }

        private void spread(int at, PriorityQueue<QueueEntry> next) {
            for (int turn : seenFrom(at)) {
                double length = meters[at] + Math.hypot(x[turn] - x[at], y[turn] - y[at]);
                if (length < meters[turn]) {
                    meters[turn] = length;
                    before[turn] = at;
                    next.add(new QueueEntry(turn, length));
                }
            }
        }

        /** The turns on the way to a place that is seen from {@code last} ones; null when no way leads there. */
        int @Nullable [] to(double toX, double toY, int[] last) {
            int best = -1;
            double least = Double.POSITIVE_INFINITY;
            for (int turn : last) {
                double length = meters[turn] + Math.hypot(x[turn] - toX, y[turn] - toY);
                if (length < least) {
                    least = length;
                    best = turn;
                }
            }
            if (best < 0) {
                return null;
            }
            int[] turns = new int[x.length];
            int at = turns.length;
            for (int turn = best; turn >= 0; turn = before[turn]) {
                turns[--at] = turn;
            }
            return Arrays.copyOfRange(turns, at, turns.length);
        }
    }

    private record QueueEntry(int turn, double meters) {}
}
