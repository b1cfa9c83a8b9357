package org.dronemap.proxy.session;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.proxy.endpoint.Peer;
import org.dronemap.proxy.endpoint.PeerAddress;

/** The other side of a link in memory: keeps what is sent to it. */
final class CapturingPeer implements Peer {
    private final String transport;
    private final PeerAddress address;
    private final List<Frame> heard = new CopyOnWriteArrayList<>();

    CapturingPeer(String transport, int port) {
        this(transport, new PeerAddress("192.0.2.1", port));
    }

    CapturingPeer(String transport, PeerAddress address) {
        this.transport = transport;
        this.address = address;
    }

    List<Frame> heard() {
        return heard;
    }

    @Override
    public PeerAddress address() {
        return address;
    }

    @Override
    public String transport() {
        return transport;
    }

    @Override
    public void send(byte[] frame) {
        heard.add(frame(frame));
    }

    static Frame frame(byte[] bytes) {
        List<Frame> frames = new ArrayList<>();
        new FrameReader().read(ByteBuffer.wrap(bytes), frames::add);
        return frames.get(0);
    }

    static Frame frame(FrameWriter writer, Message message) {
        return frame(writer.frame(message));
    }
}
