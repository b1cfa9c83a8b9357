package org.dronemap.store.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.stream.Stream;

/**
 * Seconds of processor time used so far.
 *
 * @param own by this process, its compiler and collector included
 * @param database by all processes of the database, those that have ended since included
 * @param machine by all that runs on this machine
 */
record ProcessorTime(double own, double database, double machine) {
    private static final double TICKS_A_SECOND = 100;
    private static final double NANOS = 1e9;

    /** {@code directory}: where the database works. */
    static ProcessorTime now(Path directory) throws IOException {
        double ticks = 0;
        try (Stream<Path> processes = Files.list(Path.of("/proc"))) {
            for (Path process : processes.filter(ProcessorTime::isProcess).toList()) {
                ticks += ticks(process, directory.toRealPath());
            }
        }
        Duration own = ProcessHandle.current().info().totalCpuDuration().orElse(Duration.ZERO);
        return new ProcessorTime(own.toNanos() / NANOS, ticks / TICKS_A_SECOND, machineTicks() / TICKS_A_SECOND);
    }

    ProcessorTime since(ProcessorTime before) {
        return new ProcessorTime(own - before.own, database - before.database, machine - before.machine);
    }

    private static boolean isProcess(Path path) {
        return path.getFileName().toString().matches("\\d+");
    }

    private static double ticks(Path process, Path directory) {
        try {
            if (!process.resolve("cwd").toRealPath().startsWith(directory)) {
                return 0;
            }
            String stat = Files.readString(process.resolve("stat"));
            String[] fields = stat.substring(stat.lastIndexOf(')') + 2).split(" ");
            // In user and kernel mode, then the same of children that have ended.
            return number(fields[11]) + number(fields[12]) + number(fields[13]) + number(fields[14]);
        } catch (IOException gone) {
            return 0;
        }
    }

    /** Without what was idle or waited for disks. */
    private static double machineTicks() throws IOException {
        String[] fields = Files.readAllLines(Path.of("/proc/stat")).get(0).split("\\s+");
        return number(fields[1]) + number(fields[2]) + number(fields[3]) + number(fields[6]) + number(fields[7]);
    }

    private static double number(String field) {
        return Double.parseDouble(field);
    }

    /** Its name for people. */
    static String model() throws IOException {
        try (Stream<String> lines = Files.lines(Path.of("/proc/cpuinfo"))) {
            String model = lines.filter(line -> line.startsWith("model name"))
                    .map(line -> line.substring(line.indexOf(':') + 1).strip())
                    .findFirst()
                    .orElse("processor without a name");
            return model + ", " + Runtime.getRuntime().availableProcessors() + " cores";
        }
    }
}
