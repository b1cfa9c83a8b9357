package org.dronemap.ws.budget;

/** Kinds of work that are rate-limited for each user: requests, commands, exports and sign-in attempts. */
public enum WorkKind {
    /** Anything asked of a face. */
    REQUEST("requests"),
    /** Something told to a drone. */
    COMMAND("commands"),
    /** What costs much: files, exports, backups. */
    EXPORT("exports"),
    /** Trying to sign in, rightly or wrongly, counted by address. */
    SIGN_IN("attempts to sign in");

    private final String plural;

    WorkKind(String plural) {
        this.plural = plural;
    }

    String plural() {
        return plural;
    }
}
