package org.dronemap.sim.load;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/**
 * Load test: many clients of the state stream that read everything and count messages. One thread, so that it takes
 * little of the machine from the server.
 */
final class StreamViewers {
    private static final long PONG_NANOS = 10_000_000_000L;
    private static final long NAP_MILLIS = 20;

    private final Selector selector = Selector.open();
    private final List<StreamViewer> viewers = new ArrayList<>();

    StreamViewers(LoadArguments arguments) throws IOException {
        int count = arguments.integer("--viewers");
        for (int i = 0; i < count; i++) {
            StreamViewer viewer = new StreamViewer(arguments.integer("--port"), arguments.text("--key"));
            viewer.register(selector);
            viewers.add(viewer);
        }
    }

    /** Says when all are there, and is then told from when until when to count, in ns of the machine's own clock. */
    String run(BufferedReader in, PrintStream out) throws IOException {
        out.println("ready");
        String[] times = Objects.requireNonNull(in.readLine(), "Nobody said when to count")
                .split(" ", 2);
        return count(Long.parseLong(times[0]), Long.parseLong(times[1]));
    }

    private String count(long fromNanos, long untilNanos) throws IOException {
        long[] before = new long[viewers.size()];
        boolean counting = false;
        long pong = System.nanoTime();
        for (long now = pong; now < untilNanos; now = System.nanoTime()) {
            if (!counting && now >= fromNanos) {
                counting = true;
                before = counts();
            }
            if (now - pong >= PONG_NANOS) {
                pong += PONG_NANOS;
                for (StreamViewer viewer : viewers) {
                    viewer.pong();
                }
            }
            selector.select(NAP_MILLIS);
            for (SelectionKey key : selector.selectedKeys()) {
                ((StreamViewer) key.attachment()).read();
            }
            selector.selectedKeys().clear();
        }
        long[] heard = counts();
        for (int i = 0; i < heard.length; i++) {
            heard[i] -= before[i];
        }
        Arrays.sort(heard);
        for (StreamViewer viewer : viewers) {
            viewer.close();
        }
        return "{\"viewers\":" + heard.length + ",\"messages\":"
                + Arrays.stream(heard).sum() + ",\"fewest\":" + heard[0] + ",\"most\":" + heard[heard.length - 1] + "}";
    }

    private long[] counts() {
        return viewers.stream().mapToLong(StreamViewer::messages).toArray();
    }
}
