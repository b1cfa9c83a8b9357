package org.dronemap.proxy.roslink;

import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.LongSupplier;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.proxy.endpoint.PeerAddress;
import org.dronemap.proxy.roslink.wire.PacketReadResult;
import org.dronemap.proxy.roslink.wire.RoslinkHeader;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Counts and logs, at a bounded rate, the robot messages that the server refused. Never with a key. Thread-safe. */
final class RobotRefusals {
    private static final Logger LOG = LoggerFactory.getLogger(RobotRefusals.class);
    private static final long BETWEEN_NANOS = 5_000_000_000L;

    private final LongSupplier nanoTime;
    private final LongAdder broken = new LongAdder();
    private final LongAdder unreadable = new LongAdder();
    private final LongAdder robots = new LongAdder();
    private final LongAdder unknown = new LongAdder();
    private final AtomicLong brokenLoggedNanos;
    private final AtomicLong robotsLoggedNanos;
    private final AtomicLong unknownLoggedNanos;

    RobotRefusals(LongSupplier nanoTime) {
        this.nanoTime = nanoTime;
        long before = nanoTime.getAsLong() - BETWEEN_NANOS;
        brokenLoggedNanos = new AtomicLong(before);
        robotsLoggedNanos = new AtomicLong(before);
        unknownLoggedNanos = new AtomicLong(before);
    }

    void broken(PeerAddress from, PacketReadResult.Fault fault) {
        broken.increment();
        if (isDue(brokenLoggedNanos)) {
            LOG.warn("What came from {} {}; {} such messages so far", from, fault.phrase(), broken.sum());
        }
    }

    /** A whole message, but of a kind that robots do not send: an order, which only the cloud gives, or one of another bridge's own. */
    void unknown(PeerAddress from, RoslinkHeader header) {
        unknown.increment();
        if (isDue(unknownLoggedNanos)) {
            LOG.warn(
                    "What came from {} as {} is of a kind that robots do not send; {} such messages so far",
                    from,
                    header,
                    unknown.sum());
        }
    }

    void robot(PeerAddress from, RoslinkHeader header, String why) {
        robot(new DroneKey(from.host(), from.port(), header.systemId()), why);
    }

    void robot(DroneKey robot, String why) {
        robots.increment();
        if (isDue(robotsLoggedNanos)) {
            LOG.warn(
                    "A message of the robot at {} is not believed: {}; {} such messages so far",
                    robot,
                    why,
                    robots.sum());
        }
    }

    private boolean isDue(AtomicLong told) {
        long now = nanoTime.getAsLong();
        long before = told.get();
        return now - before >= BETWEEN_NANOS && told.compareAndSet(before, now);
    }

    /** Something came as a picture and is none. */
    void unreadable() {
        unreadable.increment();
    }

    long unreadableCount() {
        return unreadable.sum();
    }

    long unknownCount() {
        return unknown.sum();
    }

    long brokenCount() {
        return broken.sum();
    }

    long robotCount() {
        return robots.sum();
    }
}
