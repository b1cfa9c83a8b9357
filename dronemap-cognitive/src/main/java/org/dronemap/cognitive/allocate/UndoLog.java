package org.dronemap.cognitive.allocate;

import java.util.Arrays;

/** Log of the old values that the search changed in tours, to put them back in reverse order. */
final class UndoLog {
    private int[] slots = new int[256];
    private int[] values = new int[256];
    private double[] seconds = new double[256];
    private int count;

    void record(int slot, int value, double secondsThen) {
        if (count == slots.length) {
            slots = Arrays.copyOf(slots, 2 * count);
            values = Arrays.copyOf(values, 2 * count);
            seconds = Arrays.copyOf(seconds, 2 * count);
        }
        slots[count] = slot;
        seconds[count] = secondsThen;
        values[count++] = value;
    }

    int count() {
        return count;
    }

    int slot(int index) {
        return slots[index];
    }

    int value(int index) {
        return values[index];
    }

    double seconds(int index) {
        return seconds[index];
    }

    void clear() {
        count = 0;
    }
}
