package org.dronemap.ws.budget;

/** Kinds of work that a user may cause so much of. */
public enum Work {
    /** Anything asked of a face. */
    REQUEST("requests"),
    /** Something told to a drone. */
    COMMAND("commands"),
    /** What costs much: files, exports, backups. */
    EXPORT("exports"),
    /** Trying to sign in, rightly or wrongly, counted by address. */
    SIGN_IN("attempts to sign in");

    private final String plural;

    Work(String plural) {
        this.plural = plural;
    }

    String plural() {
        return plural;
    }
}
