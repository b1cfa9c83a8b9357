package org.dronemap.sim;

import java.net.URI;
import java.util.List;
import org.dronemap.sim.link.ServerAddress;
import org.dronemap.sim.robot.RobotOptions;
import org.jspecify.annotations.Nullable;

/** Parses the simulator's command line options for simulated ROSLink robots. */
final class RobotOptionsReader {
    private static final ServerAddress SERVER = new ServerAddress(false, "127.0.0.1", 25_500);

    private RobotOptionsReader() {}

    /**
     * Reads a command line.
     *
     * @throws IllegalArgumentException with a sentence that names the option and what it takes
     */
    static RobotOptions read(List<String> arguments) {
        CommandLineReader reader = new CommandLineReader(arguments);
        reader.flag("--roslink");
        String owner = reader.text("--owner", "");
        RobotOptions.Identity first = new RobotOptions.Identity(
                (int) reader.integer("--sysid", 1, 0, 65_535),
                reader.text("--key", "1243-0000-0000-FGFG"),
                owner.isEmpty() ? null : owner);
        RobotOptions options = new RobotOptions(
                (int) reader.integer("--count", 1, 1, 1_000),
                reader.choice("--kind", "rover", List.of("rover", "drone", "mixed")),
                reader.server("--connect", SERVER),
                web(reader.text("--web", "")),
                first,
                reader.number("--rate", 5, 0.5, 20),
                patience(reader.number("--cloud-patience", 0, 0, 600)),
                RobotOptions.quirks(reader.text("--quirks", "")));
        reader.finish();
        return options;
    }

    private static double patience(double seconds) {
        if (seconds > 0 && seconds < 1) {
            throw new IllegalArgumentException(
                    "--cloud-patience wants 0 or at least 1: the server is heard once a second");
        }
        return seconds;
    }

    private static @Nullable URI web(String text) {
        if (text.isEmpty()) {
            return null;
        }
        try {
            // Braces are places to fill in, and no part of an address.
            URI uri = URI.create(text.replace("{", "%7B").replace("}", "%7D"));
            if (("ws".equals(uri.getScheme()) || "wss".equals(uri.getScheme())) && uri.getHost() != null) {
                return uri;
            }
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("--web wants ws://HOST:PORT/PATH, not '" + text + "'", e);
        }
        throw new IllegalArgumentException("--web wants ws://HOST:PORT/PATH, not '" + text + "'");
    }
}
