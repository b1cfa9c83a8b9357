package org.dronemap.cognitive.follow;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.DatagramSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/** A real ArduCopter in software, freshly wiped, in a folder of its own; it speaks to one port of this machine. */
final class SitlProcess implements AutoCloseable {
    private final Path folder;
    private final Process process;

    /** {@code binary}: its {@code copter.parm} lies beside it; {@code lean}: how far it may at most, in degrees. */
    SitlProcess(Path binary, int port, double lean, double wind, long seed) {
        try {
            folder = Files.createTempDirectory("sitl");
            process = start(binary, port, own(lean, wind, seed));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** The same wind as for simulated ones, at all heights, and a battery that lasts. */
    private Path own(double lean, double wind, long seed) throws IOException {
        double from = (Math.toDegrees(seed % 7) + 180) % 360;
        List<String> lines = List.of(
                "WPNAV_SPEED 1500",
                String.format(Locale.ROOT, "ANGLE_MAX %.0f", lean * 100),
                "SIM_BATT_CAP_AH 50",
                "SIM_WIND_T 1",
                String.format(Locale.ROOT, "SIM_WIND_SPD %.2f", wind),
                String.format(Locale.ROOT, "SIM_WIND_DIR %.0f", from),
                String.format(Locale.ROOT, "SIM_WIND_TURB %.2f", wind / 4));
        return Files.write(folder.resolve("follow.parm"), lines);
    }

    private Process start(Path binary, int port, Path own) throws IOException {
        return new ProcessBuilder(
                        binary.toString(),
                        "--wipe",
                        "--model",
                        "+",
                        "--speedup",
                        "1",
                        "--defaults",
                        binary.resolveSibling("copter.parm") + "," + own,
                        "--home",
                        String.format(
                                Locale.ROOT,
                                "%.7f,%.7f,%.0f,0",
                                SimDrone.HOME.latitudeDegrees(),
                                SimDrone.HOME.longitudeDegrees(),
                                SimDrone.HOME_AMSL),
                        "--rc-in-port",
                        Integer.toString(freePort()),
                        "--serial0",
                        "udpclient:127.0.0.1:" + port,
                        "--serial1",
                        "none",
                        "--serial2",
                        "none")
                .directory(folder.toFile())
                .redirectErrorStream(true)
                .redirectOutput(folder.resolve("sitl.log").toFile())
                .start();
    }

    private static int freePort() throws IOException {
        try (DatagramSocket probe = new DatagramSocket()) {
            return probe.getLocalPort();
        }
    }

    @Override
    public void close() {
        process.destroyForcibly().onExit().join();
        try (Stream<Path> all = Files.walk(folder)) {
            for (Path each : all.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(each);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
