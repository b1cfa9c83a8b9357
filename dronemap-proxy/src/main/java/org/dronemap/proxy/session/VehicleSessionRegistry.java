package org.dronemap.proxy.session;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.proxy.endpoint.Peer;
import org.dronemap.proxy.endpoint.PeerCounters;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.dronemap.proxy.mavlink.procedure.MavlinkTarget;
import org.dronemap.proxy.mavlink.translate.VehicleType;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Opens sessions for MAVLink vehicles that connect, up to a limit. Any thread. */
public final class VehicleSessionRegistry implements PeerHandler.Factory {
    private static final Logger LOG = LoggerFactory.getLogger(VehicleSessionRegistry.class);
    private static final int MAX_SESSIONS = 5_000;
    private static final long BETWEEN_WORDS_NANOS = 60_000_000_000L;

    private final SessionDependencies surroundings;
    private final FrameWriter greetings =
            new FrameWriter(MavlinkTarget.OWN_SYSTEM_ID, MavlinkTarget.OWN_COMPONENT_ID, 2);
    private final Set<VehicleLink> links = ConcurrentHashMap.newKeySet();
    private final AtomicInteger open = new AtomicInteger();
    private final LongAdder refused = new LongAdder();
    private final AtomicLong lastWordNanos = new AtomicLong(Long.MIN_VALUE);

    public VehicleSessionRegistry(SessionDependencies surroundings) {
        this.surroundings = surroundings;
    }

    @Override
    public PeerHandler opened(Peer peer, PeerCounters counters) {
        return new VehiclePeerHandler(this, peer, counters);
    }

    @Override
    public byte[] greeting() {
        synchronized (greetings) {
            return greetings.frame(AutopilotChannel.OWN_HEARTBEAT);
        }
    }

    /** A way in for recorded frames; {@code number} tells recordings apart. */
    public ReplayFeed replay(int number) {
        return new ReplayFeed(this, number);
    }

    /** What went over the links of all vehicles, once for each key; recordings have no link. */
    public List<VehicleTraffic> traffic() {
        return List.copyOf(links.stream()
                .map(VehicleLink::traffic)
                .collect(Collectors.toMap(
                        traffic -> traffic.key() + traffic.transport(), Function.identity(), VehicleTraffic::and))
                .values());
    }

    /** Sessions that are open now. */
    public int openCount() {
        return open.get();
    }

    /** Heartbeats of vehicles that found no room. */
    public long refusedCount() {
        return refused.sum();
    }

    /** A session for the vehicle that this frame is a heartbeat of, or stands for one; empty for any other frame, or without room. */
    Optional<VehicleLink> open(LinkOrigin label, VehicleSender downlink, Frame frame) {
        if (frame.systemId() == 0
                || surroundings.watch().precautions().refuses(label.peer())
                || VehicleType.announced(frame).isEmpty()) {
            return Optional.empty();
        }
        if (open.incrementAndGet() > MAX_SESSIONS) {
            open.decrementAndGet();
            refuse(label);
            return Optional.empty();
        }
        VehicleLink link = new VehicleLink(label, downlink, frame, surroundings.nanoTime());
        link.belongsTo(new VehicleSession(surroundings, link, frame, this::oneEnded));
        if (!label.replay()) {
            links.add(link);
        }
        return Optional.of(link);
    }

    private void oneEnded() {
        links.removeIf(VehicleLink::isOver);
        open.decrementAndGet();
    }

    private void refuse(LinkOrigin label) {
        refused.increment();
        long now = surroundings.now();
        long last = lastWordNanos.get();
        if ((last == Long.MIN_VALUE || now - last > BETWEEN_WORDS_NANOS) && lastWordNanos.compareAndSet(last, now)) {
            LOG.warn("There are {} sessions already; {} was turned away", MAX_SESSIONS, label.key());
        }
    }
}
