package org.dronemap.proxy.session;

import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.Map;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.proxy.endpoint.Peer;
import org.dronemap.proxy.endpoint.PeerCounters;
import org.dronemap.proxy.endpoint.PeerHandler;

/**
 * Receives MAVLink bytes from one address, and passes the frames to the vehicles behind it by system id. Owned by the
 * endpoint's thread.
 */
final class VehiclePeerHandler implements PeerHandler {
    private final VehicleSessionRegistry table;
    private final Peer peer;
    private final PeerCounters counters;
    private final FrameReader reader = new FrameReader();
    private final Map<Integer, VehicleLink> links = new HashMap<>();
    private final EarlyVersions beforehand = new EarlyVersions();
    private long countedFrames;
    private long countedBroken;

    VehiclePeerHandler(VehicleSessionRegistry table, Peer peer, PeerCounters counters) {
        this.table = table;
        this.peer = peer;
        this.counters = counters;
    }

    @Override
    public void received(ByteBuffer bytes) {
        if (peer.isDatagram()) {
            reader.readDatagram(bytes, this::route);
        } else {
            reader.read(bytes, this::route);
        }
        FrameReader.Counts counts = reader.counts();
        long frames = counts.goodFrames() + counts.unverifiedFrames();
        counters.received(frames - countedFrames, counts.skippedBytes() - countedBroken);
        countedFrames = frames;
        countedBroken = counts.skippedBytes();
    }

    private void route(Frame frame) {
        int systemId = frame.systemId();
        VehicleLink link = links.get(systemId);
        if (link == null || link.isOver()) {
            VehicleLink opened = table.open(LinkOrigin.of(peer, systemId), new VehicleSender(peer), frame)
                    .orElse(null);
            if (opened == null) {
                beforehand.received(frame);
                return;
            }
            link = opened;
            beforehand.replayTo(opened, systemId);
            links.put(systemId, opened);
        }
        long lostBefore = link.lost();
        if (!link.arrived(frame)) {
            counters.droppedIn();
        }
        counters.lost(link.lost() - lostBefore);
    }

    /** The sessions run out by themselves: what is under way goes on if the vehicle comes back in time. */
    @Override
    public void closed() {
        links.values().forEach(VehicleLink::broke);
        links.clear();
    }
}
