package org.dronemap.ws.process;

import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import org.dronemap.core.cloud.Lane;
import org.dronemap.core.process.Beginning;
import org.dronemap.core.process.PastEnd;
import org.dronemap.core.process.PeerName;
import org.dronemap.core.process.PeerWatch;
import org.dronemap.core.process.Precautions;
import org.dronemap.core.time.Time;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The process of one data directory: knows how those before it ended, and ends itself when it cannot do its duty. */
public final class ThisProcess implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(ThisProcess.class);

    private final RunFile run;
    private final ProcessEnd end;
    private final Precautions precautions;
    private final @Nullable PastEnd before;
    private final Time time;

    private ThisProcess(RunFile run, List<PastEnd> ends, Time time) {
        this.run = run;
        this.time = time;
        this.end = new ProcessEnd(run, time.clock());
        this.before = run.before().orElse(null);
        this.precautions = Precautions.after(ends, time.clock().instant());
    }

    /**
     * From here on an error that ends a thread ends the process.
     *
     * @param exitCode of the process before; empty: nobody knows it
     */
    public static ThisProcess begin(Path dataDirectory, String exitCode, Time time) {
        Instant now = time.clock().instant();
        RunFile run = RunFile.begin(dataDirectory.resolve("run-state"), now, exitCode);
        EndsFile file = new EndsFile(dataDirectory.resolve("past-ends"));
        List<PastEnd> ends = run.before().map(file::with).orElseGet(file::all);
        ThisProcess process = new ThisProcess(run, ends, time);
        process.tell();
        Thread.setDefaultUncaughtExceptionHandler(process.end);
        return process;
    }

    private void tell() {
        if (before != null) {
            LOG.warn("The server ended by itself at {}. {}: {}", before.at(), before.part(), before.why());
        }
        if (precautions.careful()) {
            LOG.error(
                    "The server ended {} times within two minutes: it starts without operations, and takes nothing from {}",
                    precautions.ends().size(),
                    precautions.refused().isEmpty()
                            ? "nobody in particular"
                            : precautions.refused().stream()
                                    .map(PeerName::toString)
                                    .toList());
        }
    }

    public Beginning beginning() {
        return new Beginning(before, new PeerWatch(run, precautions));
    }

    /** Until it is closed. */
    public SelfCheck lookAfter(List<Lane> lanes) {
        return new SelfCheck(run, end, lanes, time);
    }

    /** It was stopped: the next one has nothing to wonder about. */
    @Override
    public void close() {
        run.stopped();
    }
}
