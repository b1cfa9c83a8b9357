package org.dronemap.ws.wiring;

import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.dronemap.core.zone.ZoneBook;
import org.dronemap.ws.service.RunZones;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Has mission runs told of zones: at once when one comes or changes, and every ten seconds for those whose time comes, and for
 * runs that were taken up again. On a thread of its own, for the conductor is waited for.
 */
final class RunZoneWatch implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(RunZoneWatch.class);
    private static final long RHYTHM_SECONDS = 10;

    private final RunZones zones;
    private final AtomicBoolean due = new AtomicBoolean();
    private final ScheduledExecutorService thread = Executors.newSingleThreadScheduledExecutor(task -> {
        Thread created = new Thread(task, "run-zones");
        created.setDaemon(true);
        return created;
    });

    private final ScheduledFuture<?> looks;

    RunZoneWatch(RunZones zones, ZoneBook book) {
        this.zones = zones;
        looks = thread.scheduleWithFixedDelay(this::look, RHYTHM_SECONDS, RHYTHM_SECONDS, TimeUnit.SECONDS);
        book.onChange(change -> {
            if (!thread.isShutdown() && due.compareAndSet(false, true)) {
                thread.execute(this::look);
            }
        });
    }

    private void look() {
        due.set(false);
        try {
            zones.tell();
        } catch (RuntimeException e) {
            LOG.error("Not every mission run could be told of the zones; it is tried again", e);
        }
    }

    @Override
    public void close() {
        looks.cancel(false);
        thread.shutdown();
    }
}
