package org.dronemap.store.postgres.bundled;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** A JVM of its own that runs {@link KilledDatabaseWriter}, to be killed without mercy. */
final class KilledDatabaseProcess implements AutoCloseable {
    private final Process process;
    private final BufferedReader output;

    KilledDatabaseProcess(Path directory, String prefix, int count) throws IOException {
        String classPath = System.getProperty("surefire.test.class.path", System.getProperty("java.class.path"));
        process = new ProcessBuilder(List.of(
                        System.getProperty("java.home") + File.separator + "bin" + File.separator + "java",
                        "-Xmx128m",
                        // It lives for seconds and is to begin soon.
                        "-XX:TieredStopAtLevel=1",
                        "-cp",
                        classPath,
                        KilledDatabaseWriter.class.getName(),
                        directory.toString(),
                        prefix,
                        Integer.toString(count)))
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        output = process.inputReader(StandardCharsets.UTF_8);
    }

    /** The next line that says something of ours (and not of the log); null at the end. */
    String line() throws IOException {
        String line = output.readLine();
        while (line != null && line.contains(" ")) {
            line = output.readLine();
        }
        return line;
    }

    /** As kill -9 does it, keeping open what it had said; returns when the process is gone. */
    void kill() throws InterruptedException {
        process.toHandle().destroyForcibly();
        if (!process.waitFor(20, TimeUnit.SECONDS)) {
            throw new IllegalStateException("the child cannot be killed");
        }
    }

    @Override
    public void close() {
        process.destroyForcibly();
    }
}
