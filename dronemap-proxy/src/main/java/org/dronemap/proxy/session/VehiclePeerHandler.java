package org.dronemap.proxy.session;

import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.Map;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.proxy.endpoint.Peer;
import org.dronemap.proxy.endpoint.PeerCounters;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.jspecify.annotations.Nullable;

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
    private final Map<Integer, AutopilotChoice> choices = new HashMap<>();
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
        VehicleLink known = links.get(systemId);
        VehicleLink link = known == null || known.isOver() ? null : known;
        AutopilotChoice choice = choices.computeIfAbsent(systemId, id -> new AutopilotChoice());
        if (link == null || choice.isContradictedBy(frame)) {
            VehicleLink opened = open(choice, frame);
            if (opened != null) {
                if (link != null) {
                    link.replacedBy(opened);
                }
                beforehand.replayTo(opened, frame);
                links.put(systemId, opened);
                link = opened;
            }
        }
        if (link == null) {
            beforehand.received(frame);
            return;
        }
        long lostBefore = link.lost();
        if (!link.arrived(frame)) {
            counters.droppedIn();
        }
        counters.lost(link.lost() - lostBefore);
    }

    private @Nullable VehicleLink open(AutopilotChoice choice, Frame frame) {
        if (!choice.admits(frame)) {
            return null;
        }
        VehicleLink opened = table.open(LinkOrigin.of(peer, frame.systemId()), new VehicleSender(peer), frame)
                .orElse(null);
        if (opened != null) {
            choice.chosen(frame);
        }
        return opened;
    }

    /** The sessions run out by themselves: what is under way goes on if the vehicle comes back in time. */
    @Override
    public void closed() {
        links.values().forEach(VehicleLink::broke);
        links.clear();
    }
}
