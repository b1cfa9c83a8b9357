package org.dronemap.proxy.endpoint;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.util.concurrent.ThreadLocalRandom;

/** Ports for servers that go away and come back: below those that the system lends to whoever dials meanwhile. */
final class UnusedPorts {
    private static final int FIRST = 20_000;
    private static final int LAST = 32_000;
    private static final int TRIES = 100;

    private UnusedPorts() {}

    /** A port that nobody listens on now. */
    static int free() throws IOException {
        IOException why = new IOException("no port was tried");
        for (int tries = 0; tries < TRIES; tries++) {
            int port = ThreadLocalRandom.current().nextInt(FIRST, LAST);
            try (ServerSocket probe = new ServerSocket(port, 1, InetAddress.getLoopbackAddress())) {
                return probe.getLocalPort();
            } catch (IOException taken) {
                why = taken;
            }
        }
        throw why;
    }
}
