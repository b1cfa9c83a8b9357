package org.dronemap.ws.process;

import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import org.dronemap.core.cloud.lane.Lane;
import org.dronemap.core.process.PeerCrashGuard;
import org.dronemap.core.process.PeerPattern;
import org.dronemap.core.process.ProcessCrash;
import org.dronemap.core.process.ProcessStart;
import org.dronemap.core.process.SafeMode;
import org.dronemap.core.time.Time;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Watches over the server process: finds out how the one before it ended, and ends it when it can no longer work. */
public final class ProcessLifecycle implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(ProcessLifecycle.class);

    private final ProcessStateFile run;
    private final ProcessTerminator end;
    private final SafeMode precautions;
    private final @Nullable ProcessCrash before;
    private final Time time;

    private ProcessLifecycle(ProcessStateFile run, List<ProcessCrash> ends, Time time) {
        this.run = run;
        this.time = time;
        this.end = new ProcessTerminator(run, time.clock());
        this.before = run.before().orElse(null);
        this.precautions = SafeMode.after(ends, time.clock().instant());
    }

    /**
     * From here on an error that ends a thread ends the process.
     *
     * @param exitCode of the process before; empty: nobody knows it
     */
    public static ProcessLifecycle begin(Path dataDirectory, String exitCode, Time time) {
        Instant now = time.clock().instant();
        ProcessStateFile run = ProcessStateFile.begin(dataDirectory.resolve("run-state"), now, exitCode);
        ProcessEndLog file = new ProcessEndLog(dataDirectory.resolve("past-ends"));
        List<ProcessCrash> ends = run.before().map(file::with).orElseGet(file::all);
        ProcessLifecycle process = new ProcessLifecycle(run, ends, time);
        process.logPastEnd();
        Thread.setDefaultUncaughtExceptionHandler(process.end);
        return process;
    }

    private void logPastEnd() {
        if (before != null) {
            LOG.warn("The server ended by itself at {}. {}: {}", before.at(), before.part(), before.why());
        }
        if (precautions.isActive()) {
            LOG.error(
                    "The server ended {} times within two minutes: it starts without operations, and takes nothing from {}",
                    precautions.ends().size(),
                    precautions.refused().isEmpty()
                            ? "nobody in particular"
                            : precautions.refused().stream()
                                    .map(PeerPattern::toString)
                                    .toList());
        }
    }

    public ProcessStart beginning() {
        return new ProcessStart(before, new PeerCrashGuard(run, precautions));
    }

    /** Until it is closed. */
    public ProcessWatchdog lookAfter(List<Lane> lanes) {
        return new ProcessWatchdog(run, end, lanes, time);
    }

    /** It was stopped: the next one has nothing to wonder about. */
    @Override
    public void close() {
        run.stopped();
    }
}
