package org.dronemap.proxy.outlet.client;

import java.util.concurrent.atomic.LongAdder;
import org.dronemap.mavlink.signing.SignatureVerdict;

/**
 * Counters of frames that the outlet refused from ground stations, or could not pass on, since the start. Any thread.
 */
public final class OutletCounts {
    private final LongAdder unsigned = new LongAdder();
    private final LongAdder badSignature = new LongAdder();
    private final LongAdder replayed = new LongAdder();
    private final LongAdder tooOld = new LongAdder();
    private final LongAdder turnedAway = new LongAdder();
    private final LongAdder elsewhere = new LongAdder();
    private final LongAdder unread = new LongAdder();
    private final LongAdder notPassed = new LongAdder();

    public void refused(SignatureVerdict verdict) {
        switch (verdict) {
            case UNSIGNED -> unsigned.increment();
            case BAD_SIGNATURE -> badSignature.increment();
            case REPLAYED -> replayed.increment();
            case TOO_OLD -> tooOld.increment();
            case TOO_MANY_STREAMS -> turnedAway.increment();
            case VALID -> throw new IllegalArgumentException("a valid frame is not refused");
        }
    }

    /** The key is right, but its user may not look, was disconnected, or there are too many. */
    public void turnedAway() {
        turnedAway.increment();
    }

    /** A personal port was spoken to from where it is not bound to. */
    public void elsewhere() {
        elsewhere.increment();
    }

    /** A vehicle's frame found no room on its way to the clients. */
    public void unread() {
        unread.increment();
    }

    /** A client's frame is of a kind that does not pass. */
    public void notPassed() {
        notPassed.increment();
    }

    public OutletStatus.Refused refused() {
        return new OutletStatus.Refused(
                unsigned.sum(), badSignature.sum(), replayed.sum(), tooOld.sum(), turnedAway.sum(), elsewhere.sum());
    }

    public long unreadFrames() {
        return unread.sum();
    }

    public long notPassedFrames() {
        return notPassed.sum();
    }
}
