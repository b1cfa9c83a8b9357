package org.dronemap.ws.process;

import java.lang.management.BufferPoolMXBean;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.dronemap.core.cloud.lane.Lane;
import org.dronemap.core.time.Time;
import org.dronemap.core.time.Worker;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Checks every two seconds that the server process still gets threads and memory and that its lanes move. What is
 * missing there is thrown to libraries, which keep it to themselves. Turns are counted, not seconds, so that a process
 * that stood still as a whole blames no lane.
 */
public final class ProcessWatchdog implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(ProcessWatchdog.class);
    static final Duration RHYTHM = Duration.ofSeconds(2);
    /** At the fifth check without a turn of a lane: 8 to 10 s. */
    private static final int MOST_CHECKS_WITHOUT_TURN = 4;

    private static final double NEARLY_USED_UP = 0.9;
    private static final int TRIED_BYTES = 1 << 20;

    private final ProcessStateFile run;
    private final ProcessTerminator end;
    private final List<Lane> lanes;
    private final Time time;
    private final Worker thread;
    private final Map<String, LaneProgress> standing = new ConcurrentHashMap<>();

    private record LaneProgress(long turns, int checks) {}

    public ProcessWatchdog(ProcessStateFile run, ProcessTerminator end, List<Lane> lanes, Time time) {
        this.run = run;
        this.end = end;
        this.lanes = List.copyOf(lanes);
        this.time = time;
        thread = time.worker("self-check", 1);
        var begun = thread.every(RHYTHM, RHYTHM, this::check);
        LOG.debug("The server looks after itself: {}", begun);
    }

    void check() {
        run.sign(time.clock().instant());
        // What it cannot get is an error, which ends the process.
        Thread probe = time.blocking("thread-probe", () -> {});
        LOG.trace("{} could be started", probe);
        getMemory();
        for (Lane lane : lanes) {
            check(lane);
        }
    }

    /** A little when most is used: the machine takes what can be had, which it does not do for being asked. */
    private static void getMemory() {
        long most = Runtime.getRuntime().maxMemory();
        for (BufferPoolMXBean pool : ManagementFactory.getPlatformMXBeans(BufferPoolMXBean.class)) {
            if (pool.getName().equals("direct") && pool.getMemoryUsed() > NEARLY_USED_UP * most) {
                ByteBuffer tried = ByteBuffer.allocateDirect(TRIED_BYTES);
                LOG.warn("Memory outside the heap is nearly used up; {} bytes could still be had", tried.capacity());
            }
        }
    }

    private void check(Lane lane) {
        long turns = lane.turns();
        LaneProgress before = standing.get(lane.name());
        int checks = before == null || before.turns() != turns ? 0 : before.checks() + 1;
        standing.put(lane.name(), new LaneProgress(turns, checks));
        if (checks > MOST_CHECKS_WITHOUT_TURN) {
            end.end(lane.name(), "It has stood still for " + checks * RHYTHM.toSeconds() + " s.");
        }
    }

    @Override
    public void close() {
        thread.close();
    }
}
