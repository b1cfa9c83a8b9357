package org.dronemap.example;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;

/** Address of the server, and the access key that goes with each call. */
record Connection(String server, String key) {
    private static final Set<String> THIS_MACHINE = Set.of("127.0.0.1", "localhost", "[::1]");

    /**
     * DRONEMAP_URL and DRONEMAP_KEY. Without a key, for a server on this machine, the one that it has put into its data
     * folder (DRONEMAP_DATA_DIR, or .data where this program runs), which only who started it may read.
     */
    static Connection fromEnvironment() throws FlightException {
        String server = System.getenv().getOrDefault("DRONEMAP_URL", "http://127.0.0.1:8080");
        String host = host(server);
        String key = System.getenv("DRONEMAP_KEY");
        if (key == null && THIS_MACHINE.contains(host)) {
            key = localKey();
        }
        if (key == null) {
            throw new FlightException("No access key: make one on the page of " + server
                    + " (Account, Access keys) and set DRONEMAP_KEY to it; for a server on this machine "
                    + "DRONEMAP_DATA_DIR may name its data folder instead.");
        }
        return new Connection(server.replaceFirst("/+$", ""), key.strip());
    }

    private static String host(String server) throws FlightException {
        try {
            URI address = URI.create(server);
            if (Set.of("http", "https").contains(String.valueOf(address.getScheme())) && address.getHost() != null) {
                return address.getHost();
            }
        } catch (IllegalArgumentException e) {
            throw noAddress(server, e);
        }
        throw noAddress(server, null);
    }

    private static FlightException noAddress(String server, IllegalArgumentException cause) {
        return new FlightException(
                "DRONEMAP_URL is '" + server + "'; it must be like https://drones.example:8080.", cause);
    }

    private static String localKey() throws FlightException {
        Path file = Path.of(System.getenv().getOrDefault("DRONEMAP_DATA_DIR", ".data"), "local-key");
        try {
            return Files.isReadable(file) ? Files.readString(file) : null;
        } catch (IOException e) {
            throw new FlightException("The key cannot be read from " + file + ": " + e.getMessage(), e);
        }
    }
}
