package org.dronemap.sim.autopilot;

import java.util.function.IntConsumer;

/**
 * The rates at which a simulated vehicle sends its messages, and which of them are due. Milliseconds of the vehicle's
 * clock.
 */
final class MessageStreams {
    private static final int[] EXTENDED_STATUS = {1, 24, 42};
    private static final int[] POSITION = {33};
    private static final int[] ATTITUDE = {30};
    private static final int[] HUD = {74};
    private static final int[] EXTRA = {2, 147};
    private static final int[] ALL = {1, 24, 42, 33, 30, 74, 2, 147};

    private final int[] ids;
    private final double[] periods;
    private final double[] due;
    private double nextDue;

    MessageStreams(int... ids) {
        this.ids = ids.clone();
        this.periods = new double[ids.length];
        this.due = new double[ids.length];
    }

    /** @param hertz 0 stops it; false for a message that is not known */
    boolean set(int messageId, double hertz, long nowMillis) {
        for (int i = 0; i < ids.length; i++) {
            if (ids[i] == messageId) {
                periods[i] = hertz > 0 ? 1000 / hertz : 0;
                due[i] = nowMillis;
                nextDue = nowMillis;
                return true;
            }
        }
        return false;
    }

    double hertz(int messageId) {
        for (int i = 0; i < ids.length; i++) {
            if (ids[i] == messageId) {
                return periods[i] > 0 ? 1000 / periods[i] : 0;
            }
        }
        return -1;
    }

    /** REQUEST_DATA_STREAM: whole groups at once, as older clients ask. */
    void setGroup(int group, double hertz, long nowMillis) {
        int[] members = switch (group) {
            case 0 -> ALL;
            case 2 -> EXTENDED_STATUS;
            case 6 -> POSITION;
            case 10 -> ATTITUDE;
            case 11 -> HUD;
            case 12 -> EXTRA;
            default -> new int[0];
        };
        for (int member : members) {
            set(member, hertz, nowMillis);
        }
    }

    void sendDue(long nowMillis, IntConsumer send) {
        if (nowMillis < nextDue) {
            return;
        }
        double next = Double.MAX_VALUE;
        for (int i = 0; i < ids.length; i++) {
            if (periods[i] == 0) {
                continue;
            }
            if (nowMillis >= due[i]) {
                send.accept(ids[i]);
                // Keeps the beat, and forgets beats that were missed while the vehicle could not speak.
                due[i] = nowMillis - due[i] > periods[i] ? nowMillis + periods[i] : due[i] + periods[i];
            }
            next = Math.min(next, due[i]);
        }
        nextDue = next;
    }
}
