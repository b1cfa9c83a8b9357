package org.dronemap.proxy.roslink;

import java.util.function.LongSupplier;
import org.dronemap.core.cloud.SendAuthority;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkTrend;
import org.dronemap.proxy.endpoint.Peer;
import org.dronemap.proxy.endpoint.PeerCounters;
import org.dronemap.proxy.roslink.wire.RobotMessage;
import org.dronemap.proxy.roslink.wire.RobotOrder;
import org.dronemap.proxy.roslink.wire.RobotOrderWriter;
import org.dronemap.proxy.roslink.wire.RobotSequenceTracker;
import org.dronemap.proxy.roslink.wire.RoslinkHeader;
import org.dronemap.proxy.roslink.wire.RoslinkPacket;
import org.dronemap.proxy.session.JitterMeter;
import org.dronemap.proxy.session.LinkQualityMeter;
import org.dronemap.proxy.session.VehicleTraffic;
import org.jspecify.annotations.Nullable;

/**
 * One link to a ROSLink robot: an address and a system id, with its counters. Heard on its endpoint's thread; sending
 * and measuring belong to the session's lane.
 */
final class RobotLink {
    /** Robots tell no times: their heartbeats come once a second. */
    private static final double HEARTBEAT_SECONDS = 1;

    private final Peer peer;
    private final PeerCounters counters;
    private final RobotIdentity name;
    private final int systemId;
    private final LongSupplier nanoTime;
    private final long bornNanos;
    private final RobotOrderWriter writer = new RobotOrderWriter();
    // Owned by the endpoint's thread; its counts are read by the lane. It knows copies, of which the other link has its
    // own.
    private final RobotSequenceTracker sequence = new RobotSequenceTracker();
    private final JitterMeter jitter = new JitterMeter();
    private volatile LinkQualityMeter.Counts counts = LinkQualityMeter.Counts.NONE;
    private volatile long sent;
    private volatile long lastReceivedNanos;
    private volatile RoslinkHeader header;
    private volatile boolean broken;
    private volatile boolean cut;
    /** Of the robot's messages, before this link was one of its own. Written before the session is. */
    private volatile long lostBefore;

    private volatile @Nullable RobotSession session;
    // Owned by the lane.
    private final LinkQualityMeter loss;

    RobotLink(Peer peer, PeerCounters counters, RobotIdentity name, RoslinkHeader first, LongSupplier nanoTime) {
        this.peer = peer;
        this.counters = counters;
        this.name = name;
        this.systemId = first.systemId();
        this.header = first;
        this.nanoTime = nanoTime;
        bornNanos = nanoTime.getAsLong();
        lastReceivedNanos = bornNanos;
        loss = new LinkQualityMeter(bornNanos);
    }

    /** A message as its endpoint brought it; false for a copy. On the endpoint's thread. */
    boolean arrived(RoslinkPacket packet) {
        lastReceivedNanos = nanoTime.getAsLong();
        header = packet.header();
        boolean isNew = sequence.isNew(packet.header());
        if (isNew && packet.message() instanceof RobotMessage.Heartbeat) {
            jitter.arrivedInTurn(packet.header().messageId(), HEARTBEAT_SECONDS, lastReceivedNanos);
        }
        RobotSession owner = session;
        long lost = owner == null ? 0 : lost(owner.links().numbered(packet.header()));
        counters.lost(lost - counts.lost());
        counts = new LinkQualityMeter.Counts(sequence.received(), lost, sequence.doubled());
        return isNew;
    }

    /** Robots number all that they say, by whichever link: what came by none got lost among datagrams, as connections lose nothing. */
    private long lost(long ofRobot) {
        return peer.isDatagram() ? Math.max(0, ofRobot - lostBefore) : 0;
    }

    RobotIdentity name() {
        return name;
    }

    long bornNanos() {
        return bornNanos;
    }

    String host() {
        return peer.address().host();
    }

    String transport() {
        return peer.transport();
    }

    boolean isLocal() {
        return peer.isLocal() || host().startsWith("127.") || host().equals("0:0:0:0:0:0:0:1");
    }

    DroneKey key() {
        return new DroneKey(host(), peer.address().port(), systemId);
    }

    @Nullable
    RobotSession session() {
        return session;
    }

    /** On the registry lane, once. */
    void belongsTo(RobotSession owner) {
        // What came before this moment has its place in no row: it may be older than what came by the other link since.
        lostBefore = owner.links().lost();
        session = owner;
    }

    /** Its connection has ended. Any thread. */
    void broke() {
        broken = true;
    }

    /** It is not believed any more. Any thread. */
    void cut() {
        cut = true;
    }

    /** Who calls from there next is somebody new. Any thread. */
    boolean isOver() {
        RobotSession owner = session;
        return cut || (owner != null && owner.isOver());
    }

    /** For how long nothing came; for ever when its connection has ended. Any thread. */
    long silenceNanos() {
        return broken || cut ? Long.MAX_VALUE : nanoTime.getAsLong() - lastReceivedNanos;
    }

    /** Sends as long as the mandate's fence lets it, in the shape and with the words of the robot's newest message. */
    @SuppressWarnings("NonAtomicVolatileUpdate") // the lane alone writes
    void send(RobotOrder order, SendAuthority mandate) {
        if (cut) {
            return;
        }
        mandate.fence().pass(() -> {
            sent++;
            RoslinkHeader robot = header;
            byte[] message = writer.write(robot, order);
            peer.send(message);
            RobotSession owner = session;
            if (owner != null) {
                owner.tape().sent(message, robot, mandate);
            }
        });
    }

    /** True when the quality is worth telling: once an interval at most, and only news. */
    boolean measure(long nowNanos) {
        // Robots answer nothing that could be timed.
        return loss.update(nowNanos, counted(), null, jitter.jitter());
    }

    /** What came by another link since the newest message here is not missing any more. */
    private LinkQualityMeter.Counts counted() {
        LinkQualityMeter.Counts now = counts;
        RobotSession owner = session;
        long lost = owner == null ? 0 : lost(owner.links().lost());
        return new LinkQualityMeter.Counts(now.received(), lost, now.doubled());
    }

    LinkQuality quality() {
        return loss.quality();
    }

    LinkTrend trend() {
        return loss.trend();
    }

    /** What went over it so far. Any thread. */
    VehicleTraffic traffic() {
        RobotSession owner = session;
        LinkQualityMeter.Counts now = counted();
        return new VehicleTraffic(
                key(),
                transport(),
                owner == null ? null : owner.drone(),
                now.received(),
                sent,
                now.lost(),
                now.doubled(),
                0,
                0);
    }
}
