package org.dronemap.sim.link;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetSocketAddress;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Function;
import org.dronemap.sim.autopilot.SimulatedVehicle;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Runs any number of simulated vehicles on one thread, with their sockets and clocks. Whoever is not that thread hands
 * in work by {@link #ask}.
 */
public final class SimulatedFleet implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(SimulatedFleet.class);
    private static final long BEAT_NANOS = TimeUnit.MILLISECONDS.toNanos(20);
    private static final int SLICES = 5;
    private static final int MAX_WAITING = 256;

    private final Selector selector;
    private final ServerAddress server;
    private final InetSocketAddress serverSocket;
    private final double speedup;
    private final List<SimulatedFleetMember> members = new ArrayList<>();
    private final Buffers buffers = Buffers.allocate();
    private final ArrayBlockingQueue<Runnable> waiting = new ArrayBlockingQueue<>(MAX_WAITING);
    private final Thread thread;
    private final long startNanos = System.nanoTime();
    private volatile boolean running = true;

    public SimulatedFleet(ServerAddress server, double speedup) {
        this.server = server;
        this.serverSocket = server.resolve();
        this.speedup = speedup;
        this.thread = new Thread(this::run, "fleet");
        try {
            this.selector = Selector.open();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Before {@link #start} only. */
    public void add(Function<Consumer<byte[]>, SimulatedVehicle> maker) {
        SimulatedFleetMember member = new SimulatedFleetMember(maker);
        try {
            member.attach(
                    server.tcp()
                            ? new SimulatorTcpLink(serverSocket, selector, buffers, member::received)
                            : new SimulatorUdpLink(serverSocket, selector, buffers, member::received));
        } catch (IOException e) {
            throw new UncheckedIOException("vehicle " + (members.size() + 1) + " gets no socket: " + e.getMessage(), e);
        }
        members.add(member);
    }

    public void start() {
        thread.start();
    }

    private void run() {
        try {
            long sliceNanos = members.size() > 50 ? BEAT_NANOS / SLICES : BEAT_NANOS;
            int slices = members.size() > 50 ? SLICES : 1;
            int slice = 0;
            long due = System.nanoTime();
            while (running) {
                listen(due);
                for (Runnable work = waiting.poll(); work != null; work = waiting.poll()) {
                    work.run();
                }
                long now = System.nanoTime();
                if (now >= due) {
                    advance(slice, slices, now);
                    slice = (slice + 1) % slices;
                    due = Math.max(due + sliceNanos, now - BEAT_NANOS);
                }
            }
        } catch (IOException | RuntimeException e) {
            LOG.error("The fleet has stopped", e);
        } finally {
            members.forEach(SimulatedFleetMember::close);
        }
    }

    private void listen(long dueNanos) throws IOException {
        long wait = TimeUnit.NANOSECONDS.toMillis(dueNanos - System.nanoTime() + 999_999);
        if (wait > 0) {
            selector.select(this::handle, wait);
        } else {
            selector.selectNow(this::handle);
        }
    }

    private void handle(SelectionKey key) {
        if (key.isValid() && key.attachment() instanceof SimulatorLink uplink) {
            uplink.ready(key);
        }
    }

    private void advance(int slice, int slices, long nowNanos) {
        long until = (long) ((nowNanos - startNanos) / 1e6 * speedup);
        for (int i = slice; i < members.size(); i += slices) {
            members.get(i).advance(until, nowNanos);
        }
    }

    /** Runs a question on the fleet's thread, where the vehicles may be touched. */
    public <T> CompletableFuture<T> ask(Function<List<SimulatedVehicle>, T> question) {
        CompletableFuture<T> answer = new CompletableFuture<>();
        boolean taken = waiting.offer(() -> {
            try {
                answer.complete(question.apply(
                        members.stream().map(SimulatedFleetMember::vehicle).toList()));
            } catch (RuntimeException e) {
                answer.completeExceptionally(e);
            }
        });
        if (!taken) {
            answer.completeExceptionally(new IllegalStateException("too much is waiting for the fleet already"));
        }
        selector.wakeup();
        return answer;
    }

    /** Frames that sockets did not take, of all vehicles. */
    public CompletableFuture<Long> dropped() {
        return ask(vehicles ->
                members.stream().mapToLong(SimulatedFleetMember::dropped).sum());
    }

    @Override
    public void close() {
        running = false;
        selector.wakeup();
        try {
            thread.join(2_000);
            selector.close();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (IOException e) {
            LOG.warn("The fleet's selector does not close", e);
        }
    }
}
