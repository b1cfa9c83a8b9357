package org.dronemap.proxy;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedChannelException;
import java.nio.channels.DatagramChannel;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.BiConsumer;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.Statustext;

/** A vehicle played on a real UDP socket: what it hears is kept, what it answers a test decides. */
public final class PlayedVehicle implements AutoCloseable {
    private final DatagramChannel channel;
    private final FrameWriter writer;
    private final List<Frame> heard = new CopyOnWriteArrayList<>();
    private final BiConsumer<PlayedVehicle, Frame> answers;
    private volatile Heartbeat heartbeat;
    private final CountDownLatch closing = new CountDownLatch(1);

    /** {@code answers} runs on the vehicle's own thread. */
    public PlayedVehicle(int port, FrameWriter writer, Heartbeat first, BiConsumer<PlayedVehicle, Frame> answers)
            throws IOException {
        this.writer = writer;
        this.heartbeat = first;
        this.answers = answers;
        channel = DatagramChannel.open().connect(new InetSocketAddress("127.0.0.1", port));
        start("played-reader", this::listen);
        start("played-heart", this::beat);
    }

    public static Heartbeat copter(long customMode, boolean armed) {
        return new Heartbeat(2, 3, armed ? 0x81 : 1, customMode, armed ? 4 : 3, 3);
    }

    private static void start(String name, Runnable work) {
        Thread thread = new Thread(work, name);
        thread.setDaemon(true);
        thread.start();
    }

    public synchronized void send(Message message) {
        try {
            channel.write(ByteBuffer.wrap(writer.frame(message)));
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
        FrameReader reader = new FrameReader();
        ByteBuffer buffer = ByteBuffer.allocate(2048);
        while (isOpen()) {
            try {
                buffer.clear();
                channel.read(buffer);
                buffer.flip();
                reader.read(buffer, frame -> {
                    heard.add(frame);
                    answers.accept(this, frame);
                });
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
            } while (!closing.await(200, TimeUnit.MILLISECONDS));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public void close() throws IOException {
        closing.countDown();
        channel.close();
    }
}
