package org.dronemap.proxy.outlet;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.Clock;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import org.dronemap.core.access.LinkKey;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionRequestInt;
import org.dronemap.mavlink.signing.OutgoingSigner;
import org.dronemap.mavlink.signing.SigningClock;
import org.dronemap.mavlink.signing.SigningKey;
import org.dronemap.proxy.endpoint.EndpointCounters;
import org.dronemap.proxy.endpoint.Peer;
import org.dronemap.proxy.endpoint.PeerAddress;
import org.dronemap.proxy.endpoint.PeerCounters;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.jspecify.annotations.Nullable;

/** A program at the outlet whose link is in memory; it hands over the items that it is asked for. Any thread. */
final class MatrixClient implements Peer {
    private static final int FENCE = 1;
    private static final int WAYPOINT = 16;
    private static final int CIRCLE = 5_003;
    private static final int RALLY = 5_100;

    private final PeerHandler handler;
    private final FrameWriter writer;
    private final @Nullable OutgoingSigner signer;
    private final @Nullable Consumer<Frame> listener;
    private final AtomicInteger vehicles = new AtomicInteger();
    private final AtomicInteger refusals = new AtomicInteger();
    private volatile boolean stuck;

    /** {@code user} null: it signs nothing. */
    MatrixClient(PeerHandler.Factory outlet, @Nullable String user, int systemId) {
        this(outlet, user, systemId, null);
    }

    /** {@code listener} hears all that it is sent, on the outlet's thread, and hands over the items itself. */
    MatrixClient(PeerHandler.Factory outlet, @Nullable String user, int systemId, @Nullable Consumer<Frame> listener) {
        this(outlet, user, systemId, listener, Clock.systemUTC());
    }

    /** {@code clock}: what it signs by. */
    MatrixClient(
            PeerHandler.Factory outlet,
            @Nullable String user,
            int systemId,
            @Nullable Consumer<Frame> listener,
            Clock clock) {
        this.listener = listener;
        handler = outlet.opened(this, new PeerCounters(new EndpointCounters()));
        writer = new FrameWriter(systemId, 190, 2);
        signer = user == null
                ? null
                : new OutgoingSigner(new SigningKey(key(user).secret()), new SigningClock(clock, 0), systemId);
    }

    static LinkKey key(String user) {
        try {
            byte[] passphrase = ("the passphrase of " + user).getBytes(StandardCharsets.US_ASCII);
            return new LinkKey(MessageDigest.getInstance("SHA-256").digest(passphrase));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }

    synchronized void says(Message message) {
        byte[] raw = signer == null ? writer.frame(message) : writer.frame(message, signer);
        handler.received(ByteBuffer.wrap(raw));
    }

    /** Its link takes nothing while it is. */
    void isStuck(boolean now) {
        stuck = now;
    }

    /** True when it has heard a vehicle. */
    boolean seesAVehicle() {
        return vehicles.get() > 0;
    }

    /** How many of its commands were not accepted. */
    int refusals() {
        return refusals.get();
    }

    private void hear(Frame frame) {
        if (frame.systemId() < 250) {
            vehicles.incrementAndGet();
        }
        if (frame.messageId() == CommandAck.ID && CommandAck.decode(frame).result() != 0) {
            refusals.incrementAndGet();
        }
        if (listener != null) {
            listener.accept(frame);
        } else if (frame.messageId() == MissionRequestInt.ID) {
            MissionRequestInt wanted = MissionRequestInt.decode(frame);
            says(item(frame.systemId(), wanted.seq(), wanted.missionType()));
        }
    }

    /** A home and a waypoint, a circle to stay out of, or a place to land. */
    private static MissionItemInt item(int system, int seq, int kind) {
        int command = kind == 0 ? WAYPOINT : kind == FENCE ? CIRCLE : RALLY;
        float radius = kind == FENCE ? 30 : 0;
        int frame = kind == 0 && seq == 0 ? 0 : 3;
        return new MissionItemInt(
                system, 1, seq, frame, command, 0, 1, radius, 0, 0, 0, 473_977_500, 85_456_000, 20, kind);
    }

    @Override
    public PeerAddress address() {
        return new PeerAddress("192.0.2.1", 5_000);
    }

    @Override
    public String transport() {
        return "tcp";
    }

    @Override
    public boolean offer(byte[] raw) {
        if (stuck) {
            return false;
        }
        List<Frame> frames = new ArrayList<>();
        new FrameReader().read(ByteBuffer.wrap(raw), frames::add);
        frames.forEach(this::hear);
        return true;
    }

    @Override
    public void send(byte[] frame) {
        throw new IllegalStateException("the outlet offers");
    }
}
