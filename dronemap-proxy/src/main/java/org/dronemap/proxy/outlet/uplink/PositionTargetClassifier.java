package org.dronemap.proxy.outlet.uplink;

import org.dronemap.core.command.Setpoint;
import org.jspecify.annotations.Nullable;

/**
 * Tells whether a ground station's position targets mean a single go-to or continuous steering. One client's at one
 * drone.
 */
final class PositionTargetClassifier {
    /** Places that come slower than that are gone to one by one. */
    static final long STREAM_NANOS = 1_000_000_000L;
    /** Who says the same place for so long, that often, leads by it. */
    static final long REPEATED_NANOS = 2_000_000_000L;

    private static final long OFTEN_NANOS = 300_000_000L;

    private Setpoint.@Nullable Track place;
    private long receivedNanos;
    private long sinceNanos;
    private int times;
    private boolean leads;

    /** The meaning of one position target: a go-to, a repetition of it, or part of a stream. */
    enum Meaning {
        GO_TO,
        SAID_AGAIN,
        LEADS
    }

    Meaning classify(Setpoint.Track said, long nowNanos) {
        boolean goesOn = place != null && nowNanos - receivedNanos < STREAM_NANOS;
        boolean same = said.equals(place);
        place = said;
        receivedNanos = nowNanos;
        if (!goesOn || !same) {
            leads = goesOn;
            sinceNanos = nowNanos;
            times = 0;
        }
        times++;
        if (!goesOn) {
            return Meaning.GO_TO;
        }
        long repeated = nowNanos - sinceNanos;
        leads |= repeated >= REPEATED_NANOS && repeated / times <= OFTEN_NANOS;
        return leads ? Meaning.LEADS : Meaning.SAID_AGAIN;
    }
}
