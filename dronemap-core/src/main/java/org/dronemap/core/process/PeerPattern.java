package org.dronemap.core.process;

import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * A peer that sends bytes (host, port, system id), or a group of peers where parts are left open.
 *
 * @param host an address or a device
 * @param port {@value #ANY}: any
 * @param system the vehicle's own number; {@value #ANY}: any
 */
public record PeerPattern(String host, int port, int system) {
    public static final int ANY = -1;
    private static final int FIELDS = 3;

    public PeerPattern {
        host = host.replace(' ', '_');
    }

    /** Everybody at that address. */
    public static PeerPattern at(String host, int port) {
        return new PeerPattern(host, port, ANY);
    }

    /** As it is written down. */
    public String text() {
        return host + " " + port + " " + system;
    }

    /** Null when it is no such text. */
    static @Nullable PeerPattern of(String text) {
        String[] fields = text.split(" ", -1);
        try {
            return fields.length == FIELDS
                    ? new PeerPattern(fields[0], Integer.parseInt(fields[1]), Integer.parseInt(fields[2]))
                    : null;
        } catch (NumberFormatException e) {
            return null;
        }
    }

    /** Whoever is meant by {@code other} is meant by this. */
    boolean covers(PeerPattern other) {
        return host.equals(other.host)
                && (port == ANY || port == other.port)
                && (system == ANY || system == other.system);
    }

    PeerPattern address() {
        return new PeerPattern(host, port, ANY);
    }

    /** The same vehicle at any port of its host; empty when none is named. */
    Optional<PeerPattern> vehicle() {
        return system == ANY ? Optional.empty() : Optional.of(new PeerPattern(host, ANY, system));
    }

    PeerPattern anyOfHost() {
        return new PeerPattern(host, ANY, ANY);
    }

    /** For people. */
    @Override
    public String toString() {
        return host + (port == ANY ? "" : ":" + port) + (system == ANY ? "" : ", system " + system);
    }
}
