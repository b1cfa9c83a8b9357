package org.dronemap.proxy.session;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Stream;
import org.dronemap.core.drone.DroneId;
import org.dronemap.mavlink.Frame;
import org.dronemap.proxy.endpoint.Peer;
import org.dronemap.proxy.endpoint.PeerAddress;

/**
 * Feeds the frames of a recording into vehicle sessions as if they came over a link; nothing is sent back. Frames come
 * from one thread.
 */
public final class ReplayFeed {
    private static final String TRANSPORT = "replay";

    private final VehicleSessionRegistry table;
    private final int number;
    private final Map<Integer, VehicleLink> links = new LinkedHashMap<>();
    private final Map<Integer, AutopilotChoice> choices = new HashMap<>();
    private final EarlyVersions beforehand = new EarlyVersions();

    ReplayFeed(VehicleSessionRegistry table, int number) {
        this.table = table;
        this.number = number;
    }

    /** False when there was no room: offer the same frame again. */
    public boolean offer(Frame frame) {
        int systemId = frame.systemId();
        VehicleLink link;
        synchronized (links) {
            link = links.get(systemId);
            AutopilotChoice choice = choices.computeIfAbsent(systemId, id -> new AutopilotChoice());
            if (link == null || choice.isContradictedBy(frame)) {
                VehicleLink opened = table.open(
                                LinkOrigin.ofReplay(TRANSPORT, number, systemId),
                                new VehicleSender(new DiscardingPeer(number)),
                                frame)
                        .orElse(null);
                if (opened != null) {
                    if (link != null) {
                        link.replacedBy(opened);
                    }
                    choice.chosen(frame);
                    links.put(systemId, opened);
                    beforehand.replayTo(opened, frame);
                    link = opened;
                } else if (link == null) {
                    beforehand.received(frame);
                    return true;
                }
            }
        }
        return link.isOver() || link.arrived(frame);
    }

    /** The drones that the recording showed so far. Any thread. */
    public List<DroneId> drones() {
        synchronized (links) {
            return sessions().flatMap(session -> session.drone().stream()).toList();
        }
    }

    /** The recording has no more frames. Any thread. */
    public void played() {
        synchronized (links) {
            sessions().forEach(VehicleSession::played);
        }
    }

    /** Takes its drones away. Any thread. */
    public void vanish() {
        synchronized (links) {
            sessions().forEach(session -> session.vanish(false));
        }
    }

    private Stream<VehicleSession> sessions() {
        return links.values().stream().map(VehicleLink::session).filter(Objects::nonNull);
    }

    /** A peer of a replay that discards all that is sent to it. */
    private record DiscardingPeer(int number) implements Peer {
        @Override
        public PeerAddress address() {
            return new PeerAddress(TRANSPORT, number);
        }

        @Override
        public String transport() {
            return TRANSPORT;
        }

        @Override
        public void send(byte[] frame) {
            throw new IllegalStateException("nothing is ever sent to a recording");
        }
    }
}
