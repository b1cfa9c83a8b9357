package org.dronemap.ws.process;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.process.ProcessCrash;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** File that keeps, a line each, how the last server processes of a data directory ended. */
final class ProcessEndLog {
    private static final Logger LOG = LoggerFactory.getLogger(ProcessEndLog.class);
    private static final int MOST = 20;

    private final Path file;

    ProcessEndLog(Path file) {
        this.file = file;
    }

    /** The oldest first. */
    List<ProcessCrash> all() {
        List<ProcessCrash> ends = new ArrayList<>();
        if (!Files.exists(file)) {
            return ends;
        }
        for (String line : lines()) {
            try {
                ends.add(ProcessCrash.of(line));
            } catch (RuntimeException e) {
                LOG.warn("{} holds a line that says nothing of an end; it is passed over: {}", file, line);
            }
        }
        return ends;
    }

    /** All with a newer one. */
    List<ProcessCrash> with(ProcessCrash newest) {
        List<ProcessCrash> ends = all();
        ends.add(newest);
        List<ProcessCrash> kept = ends.subList(Math.max(0, ends.size() - MOST), ends.size());
        Path fresh = file.resolveSibling(file.getFileName() + ".new");
        try {
            Files.write(fresh, kept.stream().map(ProcessCrash::text).toList());
            Files.move(fresh, file, StandardCopyOption.ATOMIC_MOVE);
        } catch (IOException e) {
            throw new UncheckedIOException("The file " + file + " cannot be written: " + e.getMessage(), e);
        }
        return List.copyOf(kept);
    }

    private List<String> lines() {
        try {
            return Files.readAllLines(file);
        } catch (IOException e) {
            throw new UncheckedIOException("The file " + file + " cannot be read: " + e.getMessage(), e);
        }
    }
}
