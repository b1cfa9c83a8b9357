package org.dronemap.proxy;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedChannelException;
import java.nio.channels.DatagramChannel;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.BiConsumer;
import org.dronemap.core.time.Time;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.Statustext;
import org.dronemap.proxy.endpoint.MemoryLink;
import org.dronemap.proxy.endpoint.PeerAddress;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.jspecify.annotations.Nullable;

/** A vehicle played on a real UDP socket, or on a link in memory: what it hears is kept, what it answers a test decides. */
public final class FakeVehicle implements AutoCloseable {
    /** MAV_CMD_COMPONENT_ARM_DISARM. */
    public static final int ARM = 400;

    private static final Duration BEAT = Duration.ofMillis(200);

    private final @Nullable DatagramChannel channel;
    private final @Nullable MemoryLink link;
    private final FrameReader reader = new FrameReader();
    private final FrameWriter writer;
    private final List<Frame> heard = new CopyOnWriteArrayList<>();
    private final BiConsumer<FakeVehicle, Frame> answers;
    private volatile Heartbeat heartbeat;
    private final CountDownLatch closing = new CountDownLatch(1);

    /** {@code answers} runs on the vehicle's own thread. */
    public FakeVehicle(int port, FrameWriter writer, Heartbeat first, BiConsumer<FakeVehicle, Frame> answers)
            throws IOException {
        this.writer = writer;
        this.heartbeat = first;
        this.answers = answers;
        link = null;
        channel = DatagramChannel.open().connect(new InetSocketAddress("127.0.0.1", port));
        start("played-reader", this::listen);
        start("played-heart", this::beat);
    }

    /** On a link in memory from that port, in that time. */
    public FakeVehicle(
            PeerHandler.Factory handlers,
            int port,
            Time time,
            FrameWriter writer,
            Heartbeat first,
            BiConsumer<FakeVehicle, Frame> answers) {
        this.writer = writer;
        this.heartbeat = first;
        this.answers = answers;
        channel = null;
        link = new MemoryLink(
                handlers, new PeerAddress("127.0.0.1", port), bytes -> hear(ByteBuffer.wrap(bytes)), time);
        var unused = time.worker("played", 1).every(Duration.ZERO, BEAT, () -> send(heartbeat));
    }

    /** True when the other side has taken its link in. */
    public boolean isAtTheDoor() {
        return link != null && !link.peers().isEmpty();
    }

    private void hear(ByteBuffer bytes) {
        reader.read(bytes, frame -> {
            heard.add(frame);
            answers.accept(this, frame);
        });
    }

    public static Heartbeat copter(long customMode, boolean armed) {
        return new Heartbeat(2, 3, armed ? 0x81 : 1, customMode, armed ? 4 : 3, 3);
    }

    /** Answers that hand the arm and disarm commands that come in to {@code then}. */
    public static BiConsumer<FakeVehicle, Frame> onArm(BiConsumer<FakeVehicle, CommandLong> then) {
        return (vehicle, frame) -> {
            if (frame.messageId() == CommandLong.ID && CommandLong.decode(frame).command() == ARM) {
                then.accept(vehicle, CommandLong.decode(frame));
            }
        };
    }

    private static void start(String name, Runnable work) {
        Thread thread = new Thread(work, name);
        thread.setDaemon(true);
        thread.start();
    }

    public synchronized void send(Message message) {
        byte[] frame = writer.frame(message);
        if (link != null) {
            link.received(frame);
            return;
        }
        try {
            channel.write(ByteBuffer.wrap(frame));
        } catch (IOException e) {
            if (isOpen()) {
                throw new IllegalStateException(e);
            }
        }
    }

    public void is(Heartbeat now) {
        heartbeat = now;
        send(now);
    }

    public Heartbeat heartbeat() {
        return heartbeat;
    }

    public void acknowledge(int command, int result) {
        send(new CommandAck(command, result, 0, 0, 255, 190));
    }

    public void say(int severity, String text) {
        send(new Statustext(severity, text, 0, 0));
    }

    /** The COMMAND_LONGs of this kind that came in, oldest first. */
    public List<CommandLong> commands(int command) {
        return heard.stream()
                .filter(frame -> frame.messageId() == CommandLong.ID)
                .map(CommandLong::decode)
                .filter(message -> message.command() == command)
                .toList();
    }

    public List<Frame> heard() {
        return heard;
    }

    private void listen() {
        ByteBuffer buffer = ByteBuffer.allocate(2048);
        while (isOpen()) {
            try {
                buffer.clear();
                channel.read(buffer);
                buffer.flip();
                hear(buffer);
            } catch (ClosedChannelException e) {
                return;
            } catch (IOException e) {
                if (isOpen()) {
                    throw new IllegalStateException(e);
                }
            }
        }
    }

    private boolean isOpen() {
        return closing.getCount() > 0;
    }

    private void beat() {
        try {
            do {
                send(heartbeat);
            } while (!closing.await(BEAT.toMillis(), TimeUnit.MILLISECONDS));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public void close() throws IOException {
        closing.countDown();
        if (channel != null) {
            channel.close();
        }
        if (link != null) {
            link.close();
        }
    }
}
