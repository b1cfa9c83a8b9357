package org.dronemap.proxy.record;

import java.io.InputStream;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.dronemap.core.time.ScheduledTask;
import org.dronemap.core.time.Time;
import org.dronemap.core.time.Worker;
import org.dronemap.proxy.session.VehicleSessionRegistry;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The running and finished replays of recordings; plays them all on one thread. Any thread. */
public final class ReplayRegistry implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(ReplayRegistry.class);
    private static final int MOST_AT_ONCE = 8;
    private static final int MOST_KEPT = 100;
    private static final Duration STEP = Duration.ofMillis(20);
    private static final Duration LONGEST_CLOSE = Duration.ofSeconds(1);
    private static final double SLOWEST = 0.1;
    private static final double FASTEST = 100;

    private final VehicleSessionRegistry sessions;
    private final Map<String, RecordingReplay> all = new LinkedHashMap<>();
    private final Time time;
    private final Worker thread;
    private final ScheduledTask steps;
    private int numbers;

    /** The source of a replay; {@code in} is closed at its end, {@code lengthBytes} 0 when not known. */
    public record Source(String name, InputStream in, long lengthBytes, double speed) {
        public Source {
            if (!(speed >= SLOWEST && speed <= FASTEST)) {
                throw new IllegalArgumentException(
                        String.format(Locale.ROOT, "speed must be 0.1 to 100 times: %s", speed));
            }
        }
    }

    public ReplayRegistry(VehicleSessionRegistry sessions, Time time) {
        this.sessions = sessions;
        this.time = time;
        thread = time.worker("replays", 1);
        steps = thread.every(STEP, STEP, this::step);
    }

    /**
     * Begins to play.
     *
     * @throws IllegalStateException with a sentence when too many play already
     */
    public synchronized RecordingReplay start(Source recording) {
        if (all.values().stream().filter(RecordingReplay::isRunning).count() >= MOST_AT_ONCE) {
            throw new IllegalStateException(
                    MOST_AT_ONCE + " recordings play already; wait for one to end, or cancel one.");
        }
        numbers++;
        RecordingReplay replay = new RecordingReplay("r" + numbers, sessions.replay(numbers), recording);
        all.put(replay.id(), replay);
        all.values().stream()
                .filter(old -> !old.isRunning())
                .findFirst()
                .filter(oldest -> all.size() > MOST_KEPT)
                .ifPresent(oldest -> all.remove(oldest.id()));
        return replay;
    }

    /** Oldest first. */
    public synchronized List<RecordingReplay> all() {
        return List.copyOf(all.values());
    }

    public synchronized Optional<RecordingReplay> find(String id) {
        return Optional.ofNullable(all.get(id));
    }

    /** Cancels one that plays, forgets one that has played; its drones go. False when there is none. */
    public boolean remove(String id) {
        RecordingReplay found;
        synchronized (this) {
            found = all.get(id);
            if (found == null) {
                return false;
            }
            found.cancel();
            if (!found.isRunning()) {
                all.remove(id);
            }
        }
        return true;
    }

    private void step() {
        for (RecordingReplay replay : all()) {
            if (replay.isRunning()) {
                try {
                    replay.step(time.nanos());
                } catch (RuntimeException e) {
                    LOG.error("The recording {} stopped", replay.status().name(), e);
                    replay.cancel();
                }
            }
        }
    }

    @Override
    public void close() {
        all().forEach(RecordingReplay::cancel);
        steps.cancel();
        if (!thread.finish(LONGEST_CLOSE)) {
            LOG.warn("A recording did not stop in time");
        }
    }
}
