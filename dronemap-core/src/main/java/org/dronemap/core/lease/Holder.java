package org.dronemap.core.lease;

/** Who commands a drone. */
public sealed interface Holder {
    /** A user, with whatever client. */
    record Person(String name) implements Holder {}

    /** Whoever flies it with a remote control or on board: goes before everybody here. */
    record Pilot() implements Holder {}

    /** The beginning of a sentence. */
    default String words() {
        return this instanceof Person person ? person.name() : "The pilot at the vehicle";
    }

    default boolean is(String user) {
        return this instanceof Person person && person.name().equals(user);
    }
}
