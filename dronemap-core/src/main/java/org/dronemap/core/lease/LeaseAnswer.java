package org.dronemap.core.lease;

/** Answer of the lease machine to an event: granted, waiting for the holder, or denied. */
public sealed interface LeaseAnswer {
    /** Done; for a command: it may go with the epoch that is current now. */
    record Granted() implements LeaseAnswer {}

    /** The holder was asked. */
    record Waiting() implements LeaseAnswer {}

    /** Not done: a reason for programs, a sentence for people. */
    record Denied(LeaseDenial reason, String why) implements LeaseAnswer {}
}
