package org.dronemap.store.postgres.bundled;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.dronemap.store.StoreException;

/** The result of a command-line tool of the bundled PostgreSQL, run to its end: exit code and output. */
record ToolResult(int exitCode, String output) {
    /** Exit code when the program is not there at all, as in a shell. */
    private static final int NOT_FOUND = 127;

    boolean succeeded() {
        return exitCode == 0;
    }

    /** Runs in {@code directory} with the environment that PostgreSQL's tools need and none of the caller's PG settings. */
    static ToolResult of(List<String> command, Path directory, Duration limit) {
        try {
            // A file and not a pipe: a daemon that inherits a pipe would keep the reader waiting.
            Path output = Files.createTempFile("dronemap-tool", ".txt");
            try {
                return run(command, directory, limit, output);
            } finally {
                Files.deleteIfExists(output);
            }
        } catch (IOException e) {
            throw new StoreException("Cannot write a temporary file: " + e.getMessage(), e);
        }
    }

    private static ToolResult run(List<String> command, Path directory, Duration limit, Path output)
            throws IOException {
        ProcessBuilder builder = new ProcessBuilder(command)
                .directory(directory.toFile())
                .redirectErrorStream(true)
                .redirectOutput(output.toFile());
        Map<String, String> environment = builder.environment();
        environment.keySet().removeIf(name -> name.startsWith("PG") || name.startsWith("LC_"));
        environment.put("LC_ALL", "C");
        Process process;
        try {
            process = builder.start();
        } catch (IOException e) {
            return new ToolResult(NOT_FOUND, String.valueOf(e.getMessage()));
        }
        try {
            process.getOutputStream().close();
            if (!process.waitFor(limit.toMillis(), TimeUnit.MILLISECONDS)) {
                process.destroyForcibly();
                throw new StoreException("\"" + String.join(" ", command) + "\" did not end within " + limit.toSeconds()
                        + " s: " + Files.readString(output, StandardCharsets.ISO_8859_1));
            }
        } catch (InterruptedException e) {
            process.destroyForcibly();
            Thread.currentThread().interrupt();
            throw new StoreException("Interrupted while \"" + String.join(" ", command) + "\" ran.", e);
        }
        return new ToolResult(
                process.exitValue(),
                Files.readString(output, StandardCharsets.ISO_8859_1).strip());
    }
}
