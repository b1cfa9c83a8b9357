package org.dronemap.ws.limit;

import java.time.Duration;

/**
 * Limits on what one client of the web server may use before it is authenticated.
 *
 * @param connectionsPerHost open at the same time
 * @param requestsPerHost being answered at the same time
 * @param patience how long a client may take for the head of a request, and for a body beyond what its size needs
 */
public record ClientLimits(int connectionsPerHost, int requestsPerHost, Duration patience) {
    /** Half of what the server has at all: one host never takes everything. */
    public static final ClientLimits DEFAULT = new ClientLimits(1_000, 100, Duration.ofSeconds(10));

    /** How long a body of so many bytes may take: a slow radio's 16 kB/s, after the patience. */
    Duration longestBody(long bytes) {
        return patience.plusMillis(bytes / SLOWEST_BYTES_PER_MILLISECOND);
    }

    private static final int SLOWEST_BYTES_PER_MILLISECOND = 16;
}
