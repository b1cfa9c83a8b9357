package org.dronemap.core.lease;

import java.util.Optional;

/** Holder of the control of a drone: a person, an operation or the pilot at the vehicle. */
public sealed interface LeaseHolder {
    /** A user, with whatever client. */
    record Person(String name) implements LeaseHolder {}

    /**
     * Something that the cloud conducts for a user; comes after people, and ends when it is over, not by silence.
     *
     * @param words the beginning of a sentence, such as: The virtual drone “Survey” of ann
     */
    record Operation(String id, String user, String words) implements LeaseHolder {}

    /** Whoever flies it with a remote control, on board or by another ground station: goes before everybody here. */
    record Pilot() implements LeaseHolder {}

    /** The beginning of a sentence. */
    default String words() {
        if (this instanceof Person person) {
            return person.name();
        }
        return this instanceof Operation operation
                ? operation.words()
                : "A pilot at the vehicle or another ground station";
    }

    /** How users know it: the user's name or the operation's words; empty: a pilot, whom nobody here knows. */
    default Optional<String> label() {
        return this instanceof Pilot ? Optional.empty() : Optional.of(words());
    }

    /** The user, or whoever the operation is conducted for; empty: a pilot, whom nobody here knows. */
    default Optional<String> userName() {
        if (this instanceof Person person) {
            return Optional.of(person.name());
        }
        return this instanceof Operation operation ? Optional.of(operation.user()) : Optional.empty();
    }

    /** The same operation, whatever it is called by now. */
    default boolean isOperation(String id) {
        return this instanceof Operation operation && operation.id().equals(id);
    }

    default boolean is(String user) {
        return this instanceof Person person && person.name().equals(user);
    }
}
