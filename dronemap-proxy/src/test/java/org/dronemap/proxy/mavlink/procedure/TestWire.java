package org.dronemap.proxy.mavlink.procedure;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BiConsumer;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.Severity;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.Statustext;
import org.jspecify.annotations.Nullable;

/**
 * A wire in memory with a clock that a test turns: keeps what an exchange sends and feeds it what a vehicle says. Every
 * message in either direction has a number, at which a fault may happen.
 */
public final class TestWire {
    public static final long TICK_NANOS = 20_000_000L;
    private static final long LATE_NANOS = 1_500_000_000L;
    private static final long OVERTAKEN_NANOS = 100_000_000L;
    private static final long AGAIN_NANOS = 300_000_000L;
    private static final long CHATTER_NANOS = 500_000_000L;

    /** Something that crosses the wire later. */
    private record Delayed(long atNanos, Runnable arrival) {}

    private final FrameWriter vehicle = new FrameWriter(1, 1, 2);
    private final List<Message> sent = new ArrayList<>();
    private final List<Message> arriving = new ArrayList<>();
    private BiConsumer<TestWire, Message> peer = (wire, message) -> {};
    private final List<Delayed> delayed = new ArrayList<>();
    private final MavlinkTarget target = new MavlinkTarget(1, 1, this::send);
    private long nowNanos = 1_000_000_000_000L;
    private @Nullable MessageFault fault;
    private int faultAt;
    private int crossed;
    private double loss;
    private double doubling;
    private long leastDelayNanos;
    private long mostDelayNanos;
    private Random random = new Random(1);
    private boolean cut;
    private boolean chatter;
    private long chatterNanos;

    public MavlinkTarget target() {
        return target;
    }

    private void send(Message message) {
        sent.add(message);
        pass(() -> peer.accept(this, message));
    }

    /** Lets that happen to the message of that number, counted from 0. */
    void fault(MessageFault what, int number) {
        fault = what;
        faultAt = number;
    }

    public void lossy(double share, Random source) {
        loss = share;
        random = source;
    }

    /** Everything takes a random time between these, so that messages overtake each other, and some come twice. */
    public void slow(double leastSeconds, double mostSeconds, double shareDoubled) {
        leastDelayNanos = (long) (leastSeconds * 1e9);
        mostDelayNanos = (long) (mostSeconds * 1e9);
        doubling = shareDoubled;
    }

    /** Nothing crosses any more, until the wire is mended. */
    void cut(boolean on) {
        cut = on;
    }

    /** The vehicle is heard all the time, whatever it answers. */
    public void chatter(boolean on) {
        chatter = on;
    }

    /** How many messages have crossed, or should have. */
    int crossed() {
        return crossed;
    }

    private void pass(Runnable arrival) {
        boolean struck = crossed++ == faultAt;
        if (cut || (loss > 0 && random.nextDouble() < loss)) {
            return;
        }
        MessageFault what = fault;
        if (!struck || what == null) {
            travel(arrival);
            if (doubling > 0 && random.nextDouble() < doubling) {
                travel(arrival);
            }
            return;
        }
        switch (what) {
            case LOST -> {}
            case LATE -> delayed.add(new Delayed(nowNanos + LATE_NANOS, arrival));
            case OVERTAKEN -> delayed.add(new Delayed(nowNanos + OVERTAKEN_NANOS, arrival));
            case DOUBLED -> {
                arrival.run();
                delayed.add(new Delayed(nowNanos + AGAIN_NANOS, arrival));
            }
        }
    }

    private void travel(Runnable arrival) {
        if (mostDelayNanos == 0) {
            arrival.run();
        } else {
            delayed.add(new Delayed(nowNanos + random.nextLong(leastDelayNanos, mostDelayNanos), arrival));
        }
    }

    /** How the vehicle answers; answers arrive with the next tick. */
    public TestWire peer(BiConsumer<TestWire, Message> answers) {
        peer = answers;
        return this;
    }

    public void answer(Message message) {
        pass(() -> arriving.add(message));
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
            letDelayedArrive();
            List<Message> now = List.copyOf(arriving);
            arriving.clear();
            now.forEach(message -> arrives(message, exchange));
            exchange.advance(nowNanos);
        }
        return exchange.outcome();
    }

    private void arrives(Message message, Exchange exchange) {
        exchange.received(frame(message), nowNanos);
        if (message instanceof Statustext said) {
            exchange.textReceived(Severity.values()[said.severity()], said.text(), nowNanos);
        }
    }

    private void letDelayedArrive() {
        List<Delayed> due =
                delayed.stream().filter(one -> one.atNanos() <= nowNanos).toList();
        delayed.removeAll(due);
        due.forEach(one -> one.arrival().run());
        if (chatter && nowNanos - chatterNanos >= CHATTER_NANOS) {
            chatterNanos = nowNanos;
            arriving.add(new Heartbeat(2, 3, 81, 0, 3, 3));
        }
    }

    /** Starts the exchange and runs it to its end. */
    public @Nullable Outcome runWhole(Exchange exchange) {
        exchange.start(nowNanos);
        return run(exchange, 120);
    }
}
