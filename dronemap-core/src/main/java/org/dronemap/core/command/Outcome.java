package org.dronemap.core.command;

/** How a command ended; every one ends in exactly one of these. */
public sealed interface Outcome {
    /** Carried out, and seen to be. */
    record Succeeded() implements Outcome {}

    /** Somebody said no before it had an effect; {@code by} is "gate" or "vehicle". */
    record Refused(String by, String reason) implements Outcome {}

    /** Accepted, but it did not come about. */
    record Failed(String reason) implements Outcome {}

    /** No answer within the stated time; {@code reason} states it. */
    record TimedOut(String reason) implements Outcome {}

    /** A newer command took its place. */
    record Superseded(String reason) implements Outcome {}

    /** It may or may not have acted, and nobody can tell any more. */
    record Unknown(String reason) implements Outcome {}
}
