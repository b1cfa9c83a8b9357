package org.dronemap.ws.organisation;

import java.time.Duration;
import java.util.function.Consumer;
import org.dronemap.core.access.GrantRegistry;
import org.dronemap.core.access.GrantStore;
import org.dronemap.core.access.OrganisationDirectory;
import org.dronemap.core.time.Time;
import org.dronemap.ws.schedule.PeriodicTask;

/** Changes organisations, groups, fleets and grants one at a time: stored first, then in force at once. Any thread. */
public final class GrantChanges {
    private static final Duration RHYTHM = Duration.ofMillis(200);

    private final GrantStore store;
    private final GrantRegistry book;

    public GrantChanges(GrantStore store, GrantRegistry book) {
        this.store = store;
        this.book = book;
        book.replace(store.directory());
    }

    /** Announces grants that begin or end by themselves, until it is closed. */
    public PeriodicTask announceRegularly(Time time) {
        return new PeriodicTask(
                time, "grants", RHYTHM, book::announce, "Not everybody could be told that a grant has begun or ended");
    }

    public OrganisationDirectory holdings() {
        return book.directory();
    }

    GrantRegistry book() {
        return book;
    }

    public boolean isOnlyGranted(String user) {
        return book.isOnlyGranted(user);
    }

    synchronized void make(Consumer<GrantStore> change) {
        try {
            change.accept(store);
        } finally {
            book.replace(store.directory());
        }
    }

    public void forgetUser(String name) {
        make(kept -> kept.forgetUser(name));
    }
}
