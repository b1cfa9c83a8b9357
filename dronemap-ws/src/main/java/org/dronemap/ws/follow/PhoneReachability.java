package org.dronemap.ws.follow;

import java.util.HashMap;
import java.util.Iterator;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.dronemap.core.operation.ReporterState;
import org.dronemap.ws.stream.StreamConnection;
import org.dronemap.ws.stream.StreamConnectionListener;
import org.dronemap.ws.stream.StreamEnding;
import org.jspecify.annotations.Nullable;

/**
 * Tells follows whether the followed phone, connected to the stream, is reporting, asleep, cut off or gone. Any thread:
 * what is told last of a phone is what is known last, so one at a time; rounds belong to the pump.
 */
final class PhoneReachability implements StreamConnectionListener {
    private static final long ROUND_NANOS = TimeUnit.SECONDS.toNanos(1);
    private static final long QUIET_NANOS = TimeUnit.MILLISECONDS.toNanos(2_500);
    private static final long DEAF_NANOS = TimeUnit.MILLISECONDS.toNanos(3_500);

    private final ReachabilityListener follows;
    private final Map<String, Phone> phones = new HashMap<>();
    // Owned by the pump.
    private long roundNanos = System.nanoTime();

    /** Listener for changes of how phones are reached. */
    @FunctionalInterface
    interface ReachabilityListener {
        /** False when that follow is not under way. */
        boolean reached(String follow, ReporterState how);
    }

    /** {@code withReported}: how it was said to be reached last; null: not yet. */
    private record Phone(
            StreamConnection client,
            long sentNanos,
            @Nullable ReporterState withReported) {
        Phone withReported(ReporterState reach) {
            return new Phone(client, sentNanos, reach);
        }
    }

    PhoneReachability(ReachabilityListener follows) {
        this.follows = follows;
    }

    /** This client said where the phone of that follow is, or that it is there. */
    synchronized void received(StreamConnection client, String follow) {
        Phone before = phones.put(follow, new Phone(client, client.nowNanos(), ReporterState.SPEAKS));
        if (before == null || before.withReported() != ReporterState.SPEAKS) {
            follows.reached(follow, ReporterState.SPEAKS);
        }
    }

    /**
     * One that breaks off right after it has answered was ended at the phone: a network that is gone says nothing at all.
     */
    @Override
    public synchronized void disconnected(StreamConnection client, StreamEnding ending) {
        boolean broken = ending == StreamEnding.BROKEN;
        if (!broken && ending != StreamEnding.LEFT) {
            // It did not wish to go: it is back soon, or rounds find out that it is not.
            return;
        }
        long nowNanos = client.nowNanos();
        for (Iterator<Map.Entry<String, Phone>> all = phones.entrySet().iterator(); all.hasNext(); ) {
            Map.Entry<String, Phone> one = all.next();
            Phone phone = one.getValue();
            // One that has connected anew meanwhile is not gone.
            if (phone.client() == client) {
                all.remove();
                follows.reached(
                        one.getKey(),
                        broken && nowNanos - answered(phone) >= DEAF_NANOS ? ReporterState.CUT : ReporterState.GONE);
            }
        }
    }

    /** Asks each connection for a sign of life once a second, and says what has changed. */
    @Override
    public synchronized void round(long nowNanos) {
        if (nowNanos - roundNanos < ROUND_NANOS) {
            return;
        }
        roundNanos = nowNanos;
        for (Iterator<Map.Entry<String, Phone>> all = phones.entrySet().iterator(); all.hasNext(); ) {
            Map.Entry<String, Phone> one = all.next();
            Phone phone = one.getValue();
            phone.client().probe();
            ReporterState reach = reach(phone, nowNanos);
            if (reach != phone.withReported()) {
                one.setValue(phone.withReported(reach));
            }
            if (!follows.reached(one.getKey(), reach)) {
                all.remove();
            }
        }
    }

    private static ReporterState reach(Phone phone, long nowNanos) {
        if (nowNanos - phone.sentNanos() < QUIET_NANOS) {
            return ReporterState.SPEAKS;
        }
        long answered = answered(phone);
        // A browser reads no further for a page that stands still, and a phone that sleeps ends its network some time.
        boolean slept = answered - phone.sentNanos() >= DEAF_NANOS;
        return slept || nowNanos - answered < DEAF_NANOS ? ReporterState.ASLEEP : ReporterState.CUT;
    }

    private static long answered(Phone phone) {
        return Math.max(phone.sentNanos(), phone.client().answeredNanos());
    }
}
