package org.dronemap.sim.load;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.PortUnreachableException;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.Random;
import java.util.concurrent.atomic.LongAdder;
import org.jspecify.annotations.Nullable;

/**
 * Load test: a bad network, which relays UDP between vehicles and server and delays, loses, duplicates and reorders. It
 * can also give every vehicle a new address each some seconds, as mobile networks do. Owned by one thread but for
 * {@link #close} and {@link #json}.
 */
final class Impairer implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(Impairer.class.getName());
    private static final int LARGEST = 65_535;
    private static final int BUFFER_BYTES = 4 << 20;
    private static final long MILLI = 1_000_000L;
    private static final long LONGEST_SLEEP_MILLIS = 50;

    private final InetSocketAddress server;
    private final Impairment spoiling;
    private final long rebindNanos;
    private final Random chance;
    private final Selector selector = Selector.open();
    private final DatagramChannel door = DatagramChannel.open();
    private final Map<InetSocketAddress, Flow> ways = new HashMap<>();
    private final PriorityQueue<DelayedDatagram> waiting = new PriorityQueue<>();
    private final ByteBuffer buffer = ByteBuffer.allocateDirect(LARGEST);
    private final Thread thread = new Thread(this::work, "impairer");
    private long numbers;
    private volatile boolean closed;
    private final LongAdder relayed = new LongAdder();
    private final LongAdder lost = new LongAdder();
    private final LongAdder doubled = new LongAdder();
    private final LongAdder rebound = new LongAdder();

    /** One vehicle's address and the socket that stands for it before the server. */
    private static final class Flow {
        private final InetSocketAddress vehicle;
        private DatagramChannel up;
        private long sinceNanos;

        Flow(InetSocketAddress vehicle, DatagramChannel up, long sinceNanos) {
            this.vehicle = vehicle;
            this.up = up;
            this.sinceNanos = sinceNanos;
        }
    }

    /** A datagram on its way; {@code number} keeps the order of those that are due together. */
    private record DelayedDatagram(long dueNanos, long number, Flow way, boolean upwards, ByteBuffer bytes)
            implements Comparable<DelayedDatagram> {
        @Override
        public int compareTo(DelayedDatagram other) {
            int byTime = Long.compare(dueNanos, other.dueNanos);
            return byTime != 0 ? byTime : Long.compare(number, other.number);
        }
    }

    /** {@code rebindSeconds} 0: addresses stay. */
    Impairer(int port, int serverPort, Impairment spoiling, double rebindSeconds, long seed) throws IOException {
        this.server = new InetSocketAddress(InetAddress.getLoopbackAddress(), serverPort);
        this.spoiling = spoiling;
        this.rebindNanos = (long) (rebindSeconds * 1e9);
        this.chance = new Random(seed);
        door.setOption(StandardSocketOptions.SO_RCVBUF, BUFFER_BYTES);
        door.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
        door.configureBlocking(false);
        door.register(selector, SelectionKey.OP_READ);
        thread.setDaemon(true);
        thread.start();
    }

    /** Runs until standard input ends. */
    static String serve(LoadArguments arguments) throws IOException {
        Impairment spoiling = new Impairment(
                arguments.number("--delay", 0),
                arguments.number("--jitter", 0),
                arguments.number("--loss", 0),
                arguments.number("--duplicate", 0),
                arguments.number("--reorder", 0));
        try (Impairer impairer = new Impairer(
                arguments.integer("--listen"),
                arguments.integer("--port"),
                spoiling,
                arguments.number("--rebind", 0),
                (long) arguments.number("--seed", 1))) {
            byte[] untilItsEnd = System.in.readAllBytes();
            LOG.log(System.Logger.Level.DEBUG, "{0} bytes came before the end", untilItsEnd.length);
            return impairer.json();
        }
    }

    String json() {
        return "{\"relayed\":" + relayed.sum() + ",\"lost\":" + lost.sum() + ",\"doubled\":" + doubled.sum()
                + ",\"rebound\":" + rebound + "}";
    }

    int port() throws IOException {
        return ((InetSocketAddress) door.getLocalAddress()).getPort();
    }

    private void work() {
        try {
            while (!closed) {
                DelayedDatagram first = waiting.peek();
                long sleep = first == null
                        ? LONGEST_SLEEP_MILLIS
                        : Math.min(LONGEST_SLEEP_MILLIS, (first.dueNanos - System.nanoTime()) / MILLI);
                if (sleep > 0) {
                    selector.select(sleep);
                } else {
                    selector.selectNow();
                }
                List<SelectionKey> ready = List.copyOf(selector.selectedKeys());
                selector.selectedKeys().clear();
                for (SelectionKey key : ready) {
                    read(key);
                }
                deliver();
            }
            for (Flow way : ways.values()) {
                way.up.close();
            }
            door.close();
            selector.close();
        } catch (IOException e) {
            throw new IllegalStateException("the impairer broke", e);
        }
    }

    private void read(SelectionKey key) throws IOException {
        if (!key.isValid()) {
            return;
        }
        Flow known = (Flow) key.attachment();
        while (true) {
            buffer.clear();
            InetSocketAddress from = receive((DatagramChannel) key.channel());
            if (from == null) {
                return;
            }
            buffer.flip();
            byte[] bytes = new byte[buffer.remaining()];
            buffer.get(bytes);
            spoil(known == null ? way(from) : known, known == null, ByteBuffer.wrap(bytes));
        }
    }

    private @Nullable InetSocketAddress receive(DatagramChannel channel) throws IOException {
        try {
            return (InetSocketAddress) channel.receive(buffer);
        } catch (PortUnreachableException e) {
            return null;
        }
    }

    private void spoil(Flow way, boolean upwards, ByteBuffer bytes) {
        long now = System.nanoTime();
        int copies = spoiling.copies(chance);
        if (copies == 0) {
            lost.increment();
        } else if (copies == 2) {
            doubled.increment();
        }
        for (int copy = 0; copy < copies; copy++) {
            waiting.add(new DelayedDatagram(now + spoiling.delayNanos(chance), numbers++, way, upwards, bytes));
        }
    }

    private void deliver() throws IOException {
        long now = System.nanoTime();
        for (DelayedDatagram first = waiting.peek(); first != null && first.dueNanos <= now; first = waiting.peek()) {
            waiting.poll();
            if (first.upwards) {
                up(first.way, now).write(first.bytes.duplicate());
            } else {
                door.send(first.bytes.duplicate(), first.way.vehicle);
            }
            relayed.increment();
        }
    }

    private DatagramChannel up(Flow way, long now) throws IOException {
        if (rebindNanos > 0 && now - way.sinceNanos > rebindNanos) {
            way.up.close();
            way.up = open(way);
            way.sinceNanos = now;
            rebound.increment();
        }
        return way.up;
    }

    private Flow way(InetSocketAddress vehicle) throws IOException {
        Flow known = ways.get(vehicle);
        if (known != null) {
            return known;
        }
        DatagramChannel up = DatagramChannel.open();
        Flow way = new Flow(vehicle, up, System.nanoTime());
        ways.put(vehicle, way);
        connect(up, way);
        return way;
    }

    private DatagramChannel open(Flow way) throws IOException {
        DatagramChannel up = DatagramChannel.open();
        connect(up, way);
        return up;
    }

    private void connect(DatagramChannel up, Flow way) throws IOException {
        up.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
        up.connect(server);
        up.configureBlocking(false);
        up.register(selector, SelectionKey.OP_READ, way);
    }

    @Override
    public void close() throws IOException {
        closed = true;
        selector.wakeup();
        try {
            thread.join(2_000);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
