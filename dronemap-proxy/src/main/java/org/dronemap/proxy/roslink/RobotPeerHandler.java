package org.dronemap.proxy.roslink;

import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.Map;
import org.dronemap.core.link.RobotKey;
import org.dronemap.proxy.endpoint.Peer;
import org.dronemap.proxy.endpoint.PeerCounters;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.dronemap.proxy.roslink.wire.PacketReadResult;
import org.dronemap.proxy.roslink.wire.RobotMessage;
import org.dronemap.proxy.roslink.wire.RoslinkHeader;
import org.dronemap.proxy.roslink.wire.RoslinkPacket;
import org.dronemap.proxy.roslink.wire.StringOrNumber;
import org.jspecify.annotations.Nullable;

/**
 * Receives ROSLink messages from one address, and passes them to the robots behind it by system id. Owned by the
 * endpoint's thread.
 */
final class RobotPeerHandler implements PeerHandler {
    /** Real ones are alone behind their address; a router may have a few. */
    private static final int MOST_ROBOTS = 64;

    private final RobotSessionRegistry table;
    private final Peer peer;
    private final PeerCounters counters;
    private final RobotWebSocketPath path;
    private final Map<Integer, RobotLink> links = new HashMap<>();

    RobotPeerHandler(RobotSessionRegistry table, Peer peer, PeerCounters counters, RobotWebSocketPath path) {
        this.table = table;
        this.peer = peer;
        this.counters = counters;
        this.path = path;
    }

    @Override
    public void received(ByteBuffer bytes) {
        int length = bytes.remaining();
        ByteBuffer raw = bytes.duplicate();
        PacketReadResult reading = table.reader().read(bytes);
        if (reading instanceof PacketReadResult.Good good) {
            counters.received(1, 0);
            if (good.packet().message() instanceof RobotMessage.Unknown) {
                table.refusals().unknown(peer.address(), good.packet().header());
            }
            route(good.packet(), raw);
        } else if (reading instanceof PacketReadResult.Bad bad) {
            counters.received(0, length);
            table.refusals().broken(peer.address(), bad.fault());
        }
    }

    private void route(RoslinkPacket packet, ByteBuffer raw) {
        RoslinkHeader header = packet.header();
        RobotLink link = links.get(header.systemId());
        if (link != null && link.isOver()) {
            links.remove(header.systemId());
            link = null;
        }
        RobotIdentity name = name(header, link);
        if (name == null) {
            return;
        }
        if (link == null) {
            link = open(packet, name);
            if (link == null) {
                return;
            }
        } else if (!link.name().equals(name)) {
            table.refusals().robot(peer.address(), header, "it does not show the key that it came with");
            return;
        }
        deliver(link, packet, raw);
    }

    private void deliver(RobotLink link, RoslinkPacket packet, ByteBuffer raw) {
        boolean isNew = link.arrived(packet);
        RobotSession session = link.session();
        if (session != null) {
            session.tape().received(raw, packet.header());
        }
        if (session == null) {
            if (packet.message() instanceof RobotMessage.Heartbeat heartbeat) {
                table.introduce(link, RobotType.of(heartbeat.type()));
            }
        } else if (isNew && !session.offer(packet)) {
            counters.droppedIn();
        }
    }

    private @Nullable RobotLink open(RoslinkPacket packet, RobotIdentity name) {
        if (!(packet.message() instanceof RobotMessage.Heartbeat)) {
            return null;
        }
        if (links.size() >= MOST_ROBOTS) {
            table.refusals().robot(peer.address(), packet.header(), "there are too many behind one address");
            return null;
        }
        RobotLink link = new RobotLink(peer, counters, name, packet.header(), table::now);
        links.put(packet.header().systemId(), link);
        table.add(link);
        return link;
    }

    /** By what it is known; null, and reported, when what it says does not fit together. */
    private @Nullable RobotIdentity name(RoslinkHeader header, @Nullable RobotLink link) {
        StringOrNumber said = header.key();
        String key = said == null ? path.key() : said.text();
        if (path.key() != null && !path.key().equals(key)) {
            table.refusals().robot(peer.address(), header, "its key is not that of its connection");
            return null;
        }
        if (key == null) {
            // A connection belongs to whoever opened it; a datagram may come from anybody.
            return link != null && !peer.isDatagram()
                    ? link.name()
                    : RobotIdentity.ofAddress(peer.address() + ":" + header.systemId());
        }
        RobotKey issued = table.keys().find(key).orElse(null);
        if (issued == null && table.keys().isOfIssuedForm(key)) {
            table.refusals().robot(peer.address(), header, "its key is not valid");
            return null;
        }
        return issued == null ? RobotIdentity.ofOwnKey(key, header.systemId()) : name(header, issued);
    }

    private @Nullable RobotIdentity name(RoslinkHeader header, RobotKey issued) {
        String owner = header.owner() == null ? path.owner() : header.owner().text();
        if (issued.systemId() != header.systemId()) {
            table.refusals().robot(peer.address(), header, "its key was issued for another system id");
            return null;
        }
        if (issued.owner() != null && owner != null && !issued.owner().equals(owner)) {
            table.refusals().robot(peer.address(), header, "its key was issued to another owner");
            return null;
        }
        return RobotIdentity.ofIssued(issued);
    }

    /** The session runs out by itself: what is under way goes on if the robot comes back in time. */
    @Override
    public void closed() {
        links.values().forEach(RobotLink::broke);
        links.clear();
    }
}
