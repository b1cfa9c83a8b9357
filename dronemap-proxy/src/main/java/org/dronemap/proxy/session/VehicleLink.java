package org.dronemap.proxy.session;

import java.util.concurrent.atomic.LongAdder;
import java.util.function.LongSupplier;
import org.dronemap.core.cloud.IdentityProof;
import org.dronemap.core.cloud.SendAuthority;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.proxy.endpoint.PeerAddress;
import org.dronemap.proxy.mavlink.procedure.MavlinkTarget;
import org.dronemap.proxy.mavlink.procedure.RoundTripEstimator;
import org.dronemap.proxy.mavlink.procedure.RoundTripProbe;
import org.jspecify.annotations.Nullable;

/**
 * One link to a MAVLink vehicle: an address and a system id, with its counters. What it brings goes to the session that
 * it belongs to now, which may change when the vehicle is recognised. Sending and measuring belong to the session's
 * lane.
 */
final class VehicleLink {
    private final LinkOrigin label;
    private final VehicleSender downlink;
    private final int firstComponent;
    private final LinkMeter meter;
    private final LongSupplier nanoTime;
    private final LongAdder dropped = new LongAdder();
    private volatile @Nullable VehicleSession session;
    private volatile @Nullable IdentityProof proof;
    private volatile long lastReceivedNanos;
    private volatile boolean cut;
    private volatile boolean broken;

    VehicleLink(LinkOrigin label, VehicleSender downlink, Frame first, LongSupplier nanoTime) {
        this.label = label;
        this.downlink = downlink;
        firstComponent = first.componentId();
        this.nanoTime = nanoTime;
        lastReceivedNanos = nanoTime.getAsLong();
        proof = label.identity() == null ? null : new IdentityProof.OfLink(label.identity());
        MavlinkTarget target = new MavlinkTarget(
                first.systemId(), first.componentId(), message -> send(message, SendAuthority.HOUSEKEEPING));
        meter = new LinkMeter(new RoundTripProbe(target, new RoundTripEstimator()), lastReceivedNanos);
    }

    /** Takes a frame in as its endpoint brought it; false when there was no room. On the endpoint's thread. */
    boolean arrived(Frame frame) {
        long now = nanoTime.getAsLong();
        lastReceivedNanos = now;
        meter.arrived(frame, now);
        downlink.setVersion(frame.version());
        boolean taken = offer(frame);
        if (!taken) {
            dropped.increment();
        }
        return taken;
    }

    /** Takes a frame in out of its order; false when there was no room. Any thread. */
    boolean offer(Frame frame) {
        VehicleSession owner = session;
        return owner != null && !cut && owner.offer(frame);
    }

    /** From now on its frames are that session's. Any thread. */
    void belongsTo(VehicleSession owner) {
        session = owner;
    }

    @Nullable
    VehicleSession session() {
        return session;
    }

    /** It is not believed any more: who calls from there next is somebody new. Any thread. */
    void cut() {
        cut = true;
    }

    /** Another component of the vehicle turned out to be its autopilot: nothing more of this session. Any thread. */
    void replacedBy(VehicleLink autopilot) {
        cut = true;
        VehicleSession owner = session;
        if (owner != null) {
            boolean asPart = autopilot.firstComponent != firstComponent && !label.replay();
            owner.replacedBy(autopilot.session(), asPart);
        }
    }

    /** Its connection has ended: nothing will ever come over it again. Any thread. */
    void broke() {
        broken = true;
    }

    /** True when a new heartbeat from there makes a new link. Any thread. */
    boolean isOver() {
        VehicleSession owner = session;
        return cut || owner == null || owner.isOver();
    }

    void send(Message message, SendAuthority mandate) {
        if (!label.replay() && !cut) {
            downlink.send(message, mandate, nanoTime.getAsLong());
        }
    }

    /** Frames on it were signed with the key of this drone. Any thread. */
    void signedBy(DroneId drone) {
        boolean known = proof instanceof IdentityProof.OfLink
                || (proof instanceof IdentityProof.OfSignature signature
                        && signature.drone().equals(drone));
        if (!known) {
            proof = new IdentityProof.OfSignature(drone);
        }
    }

    /** What nobody but its vehicle could show; null as long as it showed nothing. Any thread. */
    @Nullable
    IdentityProof proof() {
        return proof;
    }

    /** Where it comes from now: an authenticated link may move. */
    DroneKey key() {
        PeerAddress address = downlink.address();
        return new DroneKey(address.host(), address.port(), label.key().systemId());
    }

    LinkOrigin label() {
        return label;
    }

    VehicleSender downlink() {
        return downlink;
    }

    LinkMeter meter() {
        return meter;
    }

    /** Messages missing so far. Any thread. */
    long lost() {
        return meter.counts().lost();
    }

    /** What went over it so far. Any thread. */
    VehicleTraffic traffic() {
        VehicleSession owner = session;
        LinkQualityMeter.Counts counts = meter.counts();
        return new VehicleTraffic(
                key(),
                label.transport(),
                owner == null ? null : owner.drone().orElse(null),
                counts.received(),
                downlink.sent(),
                counts.lost(),
                counts.doubled(),
                dropped.sum(),
                owner == null ? 0 : owner.waiting());
    }

    /** For how long nothing came; for ever when its connection has ended. */
    long silenceNanos(long nowNanos) {
        return broken ? Long.MAX_VALUE : nowNanos - lastReceivedNanos;
    }
}
