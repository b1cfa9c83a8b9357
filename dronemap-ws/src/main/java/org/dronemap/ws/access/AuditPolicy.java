package org.dronemap.ws.access;

import java.util.Set;

/** Rule for entering a call in the audit log: always, only if it is refused, by its HTTP method, or never. */
public enum AuditPolicy {
    /** A method that only reads leaves none, any other does. */
    BY_METHOD,
    /** One, whatever becomes of the call. */
    RECORDED,
    /** One that says where the caller came from, in any case: of all others that is told of strangers only. */
    RECORDED_WITH_PLACE,
    /** One if it is turned away; what it brought about is told by another record. */
    REFUSALS_ONLY,
    /** None, whatever becomes of it, though it changes something. */
    LEFT_OUT,
    /** None, as it changes nothing. */
    ONLY_LOOKS;

    private static final Set<String> LOOKING = Set.of("GET", "HEAD", "OPTIONS");

    /** {@code method}: of HTTP. */
    public static boolean onlyLooks(String method) {
        return LOOKING.contains(method);
    }

    /** The same for a method of HTTP. */
    AuditPolicy of(String method) {
        if (this != BY_METHOD) {
            return this;
        }
        return onlyLooks(method) ? ONLY_LOOKS : RECORDED;
    }
}
