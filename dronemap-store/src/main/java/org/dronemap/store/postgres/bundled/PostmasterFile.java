package org.dronemap.store.postgres.bundled;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** The process id and port that the bundled PostgreSQL, running or killed, left in its {@code postmaster.pid}. */
record PostmasterFile(long pid, int port) {
    private static final int PORT_LINE = 3;

    static Path path(Path cluster) {
        return cluster.resolve("postmaster.pid");
    }

    /** Empty when there is none, or none that is whole. */
    static Optional<PostmasterFile> read(Path cluster) {
        try {
            List<String> lines = Files.readAllLines(path(cluster), StandardCharsets.ISO_8859_1);
            if (lines.size() <= PORT_LINE) {
                return Optional.empty();
            }
            return Optional.of(new PostmasterFile(
                    Long.parseLong(lines.get(0).strip()),
                    Integer.parseInt(lines.get(PORT_LINE).strip())));
        } catch (NoSuchFileException | NumberFormatException e) {
            return Optional.empty();
        } catch (IOException e) {
            throw FileErrorMessages.exception("Cannot read " + path(cluster), e);
        }
    }

    /** The process, if it lives and is a PostgreSQL on this cluster: a number alone may have been given to another. */
    Optional<ProcessHandle> process(Path cluster) {
        return ProcessHandle.of(pid).filter(ProcessHandle::isAlive).filter(process -> runsOn(process, cluster));
    }

    private static boolean runsOn(ProcessHandle process, Path cluster) {
        String wanted = cluster.toString();
        return process.info().arguments().map(List::of).orElse(List.of()).contains(wanted);
    }
}
