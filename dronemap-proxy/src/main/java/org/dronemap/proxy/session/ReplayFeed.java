package org.dronemap.proxy.session;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.mavlink.Frame;
import org.dronemap.proxy.endpoint.Peer;
import org.dronemap.proxy.endpoint.PeerAddress;

/** Lets recorded frames in as if a link had brought them; nothing ever goes back. Frames come from one thread. */
public final class ReplayFeed {
    private static final String TRANSPORT = "replay";

    private final SessionTable table;
    private final int number;
    private final Map<Integer, VehicleSession> sessions = new LinkedHashMap<>();
    private final Beforehand beforehand = new Beforehand();

    ReplayFeed(SessionTable table, int number) {
        this.table = table;
        this.number = number;
    }

    /** False when there was no room: offer the same frame again. */
    public boolean offer(Frame frame) {
        int systemId = frame.systemId();
        VehicleSession session;
        synchronized (sessions) {
            session = sessions.get(systemId);
            if (session == null) {
                LinkLabel label = new LinkLabel(new DroneKey(TRANSPORT, number, systemId), TRANSPORT, true);
                session = table.open(label, new Downlink(new Nobody(number)), frame)
                        .orElse(null);
                if (session == null) {
                    beforehand.heard(frame);
                    return true;
                }
                sessions.put(systemId, session);
                beforehand.tell(session, systemId);
            }
        }
        return session.isOver() || session.arrived(frame);
    }

    /** The drones that the recording showed so far. Any thread. */
    public List<DroneId> drones() {
        synchronized (sessions) {
            return sessions.values().stream()
                    .flatMap(session -> session.drone().stream())
                    .toList();
        }
    }

    /** The recording has no more frames. Any thread. */
    public void played() {
        synchronized (sessions) {
            sessions.values().forEach(VehicleSession::played);
        }
    }

    /** Takes its drones away. Any thread. */
    public void vanish() {
        synchronized (sessions) {
            sessions.values().forEach(VehicleSession::vanish);
        }
    }

    /** Who hears what is sent to a recording. */
    private record Nobody(int number) implements Peer {
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
