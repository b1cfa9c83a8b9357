package org.dronemap.proxy.mavlink.procedure;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BiConsumer;
import org.dronemap.core.command.Outcome;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.jspecify.annotations.Nullable;

/** A wire in memory with a clock that a test turns: keeps what an exchange sends and feeds it what a vehicle says. */
public final class Wire {
    public static final long TICK_NANOS = 20_000_000L;

    private final FrameWriter vehicle = new FrameWriter(1, 1, 2);
    private final List<Message> sent = new ArrayList<>();
    private final List<Message> arriving = new ArrayList<>();
    private BiConsumer<Wire, Message> peer = (wire, message) -> {};
    private long nowNanos = 1_000_000_000_000L;

    public Target target() {
        return new Target(1, 1, message -> {
            sent.add(message);
            peer.accept(this, message);
        });
    }

    /** How the vehicle answers; answers arrive with the next tick. */
    public Wire peer(BiConsumer<Wire, Message> answers) {
        peer = answers;
        return this;
    }

    public void answer(Message message) {
        arriving.add(message);
    }

    public List<Message> sent() {
        return sent;
    }

    public <T extends Message> List<T> sent(Class<T> type) {
        return sent.stream().filter(type::isInstance).map(type::cast).toList();
    }

    public long now() {
        return nowNanos;
    }

    public Frame frame(Message message) {
        AtomicReference<@Nullable Frame> parsed = new AtomicReference<>();
        new FrameReader().read(ByteBuffer.wrap(vehicle.frame(message)), parsed::set);
        Frame frame = parsed.get();
        if (frame == null) {
            throw new AssertionError("no frame");
        }
        return frame;
    }

    /** Lets time pass until the exchange has its outcome, for at most so long. */
    public @Nullable Outcome run(Exchange exchange, double seconds) {
        long end = nowNanos + (long) (seconds * 1e9);
        while (exchange.outcome() == null && nowNanos < end) {
            nowNanos += TICK_NANOS;
            List<Message> now = List.copyOf(arriving);
            arriving.clear();
            now.forEach(message -> exchange.heard(frame(message), nowNanos));
            exchange.tick(nowNanos);
        }
        return exchange.outcome();
    }

    /** Starts the exchange and runs it to its end. */
    public @Nullable Outcome runWhole(Exchange exchange) {
        exchange.start(nowNanos);
        return run(exchange, 120);
    }
}
