package org.dronemap.core.time;

/** Something that is going to happen, once or again and again, until it is called off. */
@FunctionalInterface
public interface ScheduledTask {
    /** Does not stop what is being done already. */
    void callOff();
}
