package org.dronemap.sim.load;

import java.nio.ByteBuffer;
import java.util.Arrays;
import org.dronemap.mavlink.message.Attitude;
import org.dronemap.mavlink.message.GlobalPositionInt;

/**
 * Load test: counts the frames that reached one ground station of those due to be sent within a time span. Not
 * thread-safe.
 */
final class ArrivalCounter {
    private static final int SYSTEM_AT = 5;
    private static final int MESSAGE_AT = 7;
    private static final int PAYLOAD_AT = 10;
    private static final int UNKNOWN = -1;
    private static final int SYSTEMS = 256;

    private final SendSchedule pace;
    private final long fromNanos;
    private final long untilNanos;
    private final int[] newestStep = new int[SYSTEMS];
    private long frames;

    ArrivalCounter(SendSchedule pace, long fromNanos, long untilNanos) {
        this.pace = pace;
        this.fromNanos = fromNanos;
        this.untilNanos = untilNanos;
        Arrays.fill(newestStep, UNKNOWN);
    }

    /** A frame of MAVLink 2 that a vehicle of the load sent. */
    void came(ByteBuffer frame) {
        int system = frame.get(SYSTEM_AT) & 0xFF;
        int step = step(frame, newestStep[system]);
        newestStep[system] = step;
        long due = dueNanos(system, step);
        if (step != UNKNOWN && due >= fromNanos && due < untilNanos) {
            frames++;
        }
    }

    /** Most say their step; those that do not come after one that did. */
    private static int step(ByteBuffer frame, int before) {
        int message = (frame.get(MESSAGE_AT) & 0xFF)
                | (frame.get(MESSAGE_AT + 1) & 0xFF) << 8
                | (frame.get(MESSAGE_AT + 2) & 0xFF) << 16;
        if (message == Attitude.ID || message == GlobalPositionInt.ID) {
            return (frame.get(PAYLOAD_AT) & 0xFF)
                    | (frame.get(PAYLOAD_AT + 1) & 0xFF) << 8
                    | (frame.get(PAYLOAD_AT + 2) & 0xFF) << 16
                    | (frame.get(PAYLOAD_AT + 3) & 0xFF) << 24;
        }
        return before == UNKNOWN ? UNKNOWN : before + 1;
    }

    private long dueNanos(int system, int step) {
        return pace.dueNanos(system - LoadFrames.systemId(0), step);
    }

    /** Every vehicle has said something that was due later. */
    boolean complete() {
        int beyond = 0;
        for (int system = 0; system < SYSTEMS; system++) {
            if (newestStep[system] != UNKNOWN && dueNanos(system, newestStep[system]) >= untilNanos) {
                beyond++;
            }
        }
        return beyond == pace.vehicles();
    }

    long frames() {
        return frames;
    }
}
