package org.dronemap.store.postgres;

/** Whether the database answers. */
public sealed interface DatabaseHealth {
    record Up() implements DatabaseHealth {}

    /** With a sentence why. */
    record Down(String why) implements DatabaseHealth {}

    default boolean isUp() {
        return this instanceof Up;
    }
}
