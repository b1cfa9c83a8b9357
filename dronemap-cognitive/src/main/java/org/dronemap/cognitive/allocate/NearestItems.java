package org.dronemap.cognitive.allocate;

/** Keeps the nearest few of the items offered to it, nearest first, to find the neighbours of a waypoint. */
final class NearestItems {
    private final int[] items;
    private final double[] squares;
    private int count;

    /** Takes an item and the square of its distance. */
    @FunctionalInterface
    interface Visitor {
        void visit(int item, double squared);
    }

    NearestItems(int most) {
        items = new int[most];
        squares = new double[most];
    }

    void offer(int item, double squared) {
        if (items.length == 0 || (isFull() && squared >= squares[count - 1])) {
            return;
        }
        int at = isFull() ? count - 1 : count++;
        while (at > 0 && squares[at - 1] > squared) {
            squares[at] = squares[at - 1];
            items[at] = items[at - 1];
            at--;
        }
        squares[at] = squared;
        items[at] = item;
    }

    int count() {
        return count;
    }

    int get(int rank) {
        return items[rank];
    }

    boolean isFull() {
        return count == items.length;
    }

    boolean has(int item) {
        for (int rank = 0; rank < count; rank++) {
            if (items[rank] == item) {
                return true;
            }
        }
        return false;
    }

    /** The square of the distance beyond which nothing is taken any more; infinite while there is room. */
    double farthest() {
        return isFull() ? count == 0 ? 0 : squares[count - 1] : Double.POSITIVE_INFINITY;
    }

    void forEach(Visitor taker) {
        for (int rank = 0; rank < count; rank++) {
            taker.visit(items[rank], squares[rank]);
        }
    }
}
