package org.dronemap.sim.link;

import java.net.InetSocketAddress;
import java.net.URI;

/** The address of the server that simulated vehicles connect to, as in {@code udp://127.0.0.1:14550}. */
public record ServerAddress(boolean tcp, String host, int port) {
    /**
     * Reads an address.
     *
     * @throws IllegalArgumentException with a sentence for whoever typed it
     */
    public static ServerAddress parse(String text) {
        URI uri;
        try {
            uri = URI.create(text);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(wrong(text), e);
        }
        String scheme = uri.getScheme();
        boolean known = "udp".equals(scheme) || "tcp".equals(scheme);
        if (!known || uri.getHost() == null || uri.getPort() < 1 || uri.getPort() > 65_535) {
            throw new IllegalArgumentException(wrong(text));
        }
        return new ServerAddress("tcp".equals(scheme), uri.getHost(), uri.getPort());
    }

    private static String wrong(String text) {
        return "'" + text + "' is no address: give udp://HOST:PORT or tcp://HOST:PORT with a port within 1 to 65535";
    }

    InetSocketAddress resolve() {
        InetSocketAddress address = new InetSocketAddress(host, port);
        if (address.isUnresolved()) {
            throw new IllegalArgumentException("the host '" + host + "' has no address");
        }
        return address;
    }
}
