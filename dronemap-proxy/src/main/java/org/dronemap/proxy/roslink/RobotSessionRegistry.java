package org.dronemap.proxy.roslink;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.Function;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.dronemap.core.cloud.Claim;
import org.dronemap.core.cloud.ClaimResult;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.LinkSession;
import org.dronemap.core.cloud.lane.Lanes;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.link.RobotKey;
import org.dronemap.core.process.ActivePeers;
import org.dronemap.proxy.endpoint.Peer;
import org.dronemap.proxy.endpoint.PeerCounters;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.dronemap.proxy.endpoint.PeerMessageFormat;
import org.dronemap.proxy.record.TextMessageTap;
import org.dronemap.proxy.roslink.wire.RoslinkPacketReader;
import org.dronemap.proxy.session.Enrolment;
import org.dronemap.proxy.session.VehicleTraffic;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Creates sessions for ROSLink robots that connect, one for each robot, up to a limit. Any thread; who speaks for whom
 * is decided on the registry lane.
 */
final class RobotSessionRegistry implements PeerHandler.Factory {
    private static final Logger LOG = LoggerFactory.getLogger(RobotSessionRegistry.class);
    private static final int MOST_LINKS = 5_000;
    private static final int LARGEST_DATAGRAM = 65_535;
    private static final long BETWEEN_ALARMS_NANOS = 10_000_000_000L;

    private final CloudManager cloud;
    private final Lanes lanes;
    private final Enrolment enrolment;
    private final ActivePeers atWork;
    private final RobotKeys keys;
    private final Supplier<TextMessageTap> taps;
    private final LongSupplier nanoTime;
    private final RoslinkPacketReader reader = new RoslinkPacketReader();
    private final RobotRefusals refusals;
    private final Set<RobotLink> links = ConcurrentHashMap.newKeySet();
    // Owned by the registry lane.
    private final Map<RobotIdentity, RobotSession> sessions = new HashMap<>();
    private final Map<RobotIdentity, Long> alarmedNanos = new HashMap<>();

    RobotSessionRegistry(CloudManager cloud, Lanes lanes, RoslinkConnector.Policy policy, LongSupplier nanoTime) {
        this.cloud = cloud;
        this.lanes = lanes;
        enrolment = policy.enrolment();
        atWork = policy.doors().watch().atWork();
        keys = policy.keys();
        taps = policy.taps();
        this.nanoTime = nanoTime;
        refusals = new RobotRefusals(nanoTime);
    }

    /** For one session. */
    RobotRecordingTap tape() {
        return new RobotRecordingTap(taps.get());
    }

    @Override
    public PeerHandler opened(Peer peer, PeerCounters counters) {
        // What is asked for elsewhere was turned away at the door.
        RobotWebSocketPath path = RobotWebSocketPath.of(peer.path()).orElse(RobotWebSocketPath.BARE);
        return new RobotPeerHandler(this, peer, counters, path);
    }

    @Override
    public PeerMessageFormat speech() {
        return new PeerMessageFormat(true, LARGEST_DATAGRAM, RoslinkPacketReader.LONGEST_BYTES);
    }

    @Override
    public boolean acceptsPath(String path) {
        return RobotWebSocketPath.of(path).isPresent();
    }

    RoslinkPacketReader reader() {
        return reader;
    }

    RobotKeys keys() {
        return keys;
    }

    RobotRefusals refusals() {
        return refusals;
    }

    /** Monotonic, in ns. */
    long now() {
        return nanoTime.getAsLong();
    }

    /** What went over the links of all robots, once for each address. */
    List<VehicleTraffic> traffic() {
        return List.copyOf(links.stream()
                .map(RobotLink::traffic)
                .collect(Collectors.toMap(
                        traffic -> traffic.key() + traffic.transport(), Function.identity(), VehicleTraffic::and))
                .values());
    }

    ActivePeers atWork() {
        return atWork;
    }

    /** A link is there; the oldest silent ones go when there are too many. */
    void add(RobotLink link) {
        if (links.size() >= MOST_LINKS) {
            links.removeIf(old -> old.isOver() || old.silenceNanos() > RobotLinks.SILENT_NANOS);
        }
        if (links.size() < MOST_LINKS) {
            links.add(link);
        } else {
            link.cut();
            refusals.robot(link.key(), "there are " + MOST_LINKS + " links already");
        }
    }

    /** A link without a session brought a heartbeat. */
    void introduce(RobotLink link, RobotType type) {
        if (!lanes.registry().offer(() -> claim(link, type))) {
            LOG.debug("The registry has no room for {}; its next heartbeat tries again", link.key());
        }
    }

    private void claim(RobotLink link, RobotType type) {
        RobotKey issued = link.name().issued();
        if (issued != null && !keys.isValid(issued)) {
            link.cut();
        }
        if (link.session() != null || link.isOver()) {
            return;
        }
        RobotSession session = sessions.get(link.name());
        if (session == null || session.isOver()) {
            begin(link, type);
            return;
        }
        Optional<String> why = session.links().join(link);
        if (why.isEmpty()) {
            link.belongsTo(session);
        } else {
            keepOutside(session, link, why.get());
        }
    }

    private void begin(RobotLink link, RobotType type) {
        RobotSession session = new RobotSession(this, link, type);
        LinkSession label = new LinkSession(
                link.key(),
                link.transport(),
                false,
                type.label() + " " + link.key().systemId(),
                session);
        boolean trusted = enrolment.admits(link.isLocal());
        Claim claim =
                new Claim(label, session.identification(), link.name().proof(), trusted, now() - link.bornNanos());
        if (cloud.admit(claim) instanceof ClaimResult.Bound bound) {
            sessions.put(link.name(), session);
            session.bind(bound.link());
            link.belongsTo(session);
        } else {
            refusals.robot(link.key(), "it is not let in");
        }
    }

    /** Whoever came with the key that was issued for that drone. Any thread. */
    void disconnect(String drone) {
        lanes.registry()
                .execute(() -> sessions.values().stream()
                        .filter(session -> {
                            RobotKey issued = session.name().issued();
                            return issued != null && issued.drone().value().equals(drone) && !keys.isValid(issued);
                        })
                        .toList()
                        .forEach(RobotSession::expel));
    }

    /** Who shows the same key while the robot is heard elsewhere is told of, and gets and gives nothing. */
    private void keepOutside(RobotSession session, RobotLink link, String why) {
        refusals.robot(link.key(), why);
        DroneId drone = session.drone();
        Long before = alarmedNanos.get(session.name());
        if (drone != null && (before == null || now() - before > BETWEEN_ALARMS_NANOS)) {
            alarmedNanos.put(session.name(), now());
            cloud.publishMessage(
                    drone,
                    Severity.ALERT,
                    "Another robot at " + link.key() + " says that it is this one, but " + why
                            + ". Nothing that it says is believed, and no command goes to it.");
        }
    }

    /** Any thread. */
    void ended(RobotSession session) {
        links.removeIf(RobotLink::isOver);
        try {
            lanes.registry().execute(() -> {
                sessions.remove(session.name(), session);
                alarmedNanos.remove(session.name());
            });
        } catch (RejectedExecutionException e) {
            // It stays in the list as one that is over: the next heartbeat takes its place.
            LOG.debug("The registry has no room; {} is forgotten later", session.name(), e);
        }
    }
}
