package org.dronemap.proxy.session;

/**
 * Counts lost and duplicate messages by the MAVLink sequence numbers of one vehicle component. What comes late is taken
 * off again, what comes twice counts once. A silence that outlasts 256 messages is counted modulo 256: liveness tells
 * of those. Owned by the endpoint's thread.
 */
final class SequenceGaps {
    private static final int ROUND = 256;
    /** How far back a number may be to be a late one and no new round. */
    private static final int LATE = 32;
    /** So large a step without a pause before it is a sender that began anew. */
    private static final int ABRUPT = 64;

    private static final long PAUSE_NANOS = 250_000_000L;

    private boolean begun;
    private int newest;
    private long newestNanos;
    /** Bit i: the number {@code newest - i} came. */
    private long came;

    private long received;
    private long lost;
    private long doubled;

    void count(int sequence, long nowNanos) {
        int ahead = Math.floorMod(sequence - newest, ROUND);
        if (!begun || (ahead > ABRUPT && ahead < ROUND - LATE && nowNanos - newestNanos < PAUSE_NANOS)) {
            begin(sequence, nowNanos);
        } else if (ahead == 0 || ahead >= ROUND - LATE) {
            late(ROUND - ahead & ROUND - 1);
        } else {
            lost += ahead - 1;
            received++;
            came = ahead >= Long.SIZE ? 1 : came << ahead | 1;
            newest = sequence;
            newestNanos = nowNanos;
        }
    }

    private void begin(int sequence, long nowNanos) {
        begun = true;
        received++;
        // Nobody waits for what was sent before.
        came = -1;
        newest = sequence;
        newestNanos = nowNanos;
    }

    private void late(int back) {
        if ((came >>> back & 1) == 1) {
            doubled++;
        } else {
            came |= 1L << back;
            received++;
            lost--;
        }
    }

    /** Messages that came, each once. */
    long received() {
        return received;
    }

    /** Messages that are missing. */
    long lost() {
        return lost;
    }

    /** Copies of messages that had come already. */
    long doubled() {
        return doubled;
    }
}
