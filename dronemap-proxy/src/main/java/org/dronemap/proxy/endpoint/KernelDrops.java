package org.dronemap.proxy.endpoint;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.OptionalLong;
import java.util.regex.Pattern;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Reads from Linux how many datagrams the kernel dropped because the receive buffer of a port was full. */
final class KernelDrops {
    private static final Logger LOG = LoggerFactory.getLogger(KernelDrops.class);
    private static final Path PROC = Path.of("/proc/net");
    private static final Pattern SPACES = Pattern.compile("\\s+");
    private static final int LOCAL_ADDRESS = 1;
    private static final int DROPS = 12;

    private KernelDrops() {}

    /** The drops of the UDP socket bound to that port; empty where nobody counts them. */
    static OptionalLong of(int port) {
        return of(PROC, port);
    }

    static OptionalLong of(Path directory, int port) {
        long drops = 0;
        boolean found = false;
        for (String name : new String[] {"udp", "udp6"}) {
            Path table = directory.resolve(name);
            if (!Files.isReadable(table)) {
                continue;
            }
            try {
                for (String line : Files.readAllLines(table, StandardCharsets.US_ASCII)) {
                    String[] fields = SPACES.split(line.strip(), -1);
                    if (fields.length > DROPS && isPort(fields[LOCAL_ADDRESS], port)) {
                        found = true;
                        drops += Long.parseLong(fields[DROPS]);
                    }
                }
            } catch (IOException | NumberFormatException e) {
                LOG.debug("{} cannot be understood", table, e);
            }
        }
        return found ? OptionalLong.of(drops) : OptionalLong.empty();
    }

    private static boolean isPort(String localAddress, int port) {
        return localAddress.endsWith(":" + String.format(Locale.ROOT, "%04X", port));
    }
}
