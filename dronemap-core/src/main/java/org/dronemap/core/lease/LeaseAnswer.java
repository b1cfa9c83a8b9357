package org.dronemap.core.lease;

/** Answer to a {@link LeaseEvent} for whoever caused it. */
public sealed interface LeaseAnswer {
    /** Done; for a command: it may go with the epoch that is current now. */
    record Granted() implements LeaseAnswer {}

    /** The holder was asked. */
    record Waiting() implements LeaseAnswer {}

    /** Not done: a reason for programs, a sentence for people. */
    record Denied(LeaseDenial reason, String why) implements LeaseAnswer {}
}
