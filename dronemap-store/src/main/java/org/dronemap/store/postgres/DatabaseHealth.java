package org.dronemap.store.postgres;

/** The health of the database: up, or down with a reason. */
public sealed interface DatabaseHealth {
    record Up() implements DatabaseHealth {}

    /** With a sentence why. */
    record Down(String why) implements DatabaseHealth {}

    default boolean isUp() {
        return this instanceof Up;
    }
}
