package org.dronemap.core.time;

/** A handle on a task scheduled once or repeatedly, by which it can be cancelled. */
@FunctionalInterface
public interface ScheduledTask {
    /** Does not stop what is being done already. */
    void cancel();
}
