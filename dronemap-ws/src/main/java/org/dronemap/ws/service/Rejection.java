package org.dronemap.ws.service;

import org.jspecify.annotations.Nullable;

/** A request that is answered with a sentence instead of being carried out; each face maps it to its own form. */
public class Rejection extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final RejectionKind kind;
    private final @Nullable String commandId;

    public Rejection(RejectionKind kind, String sentence) {
        this(kind, sentence, null);
    }

    private Rejection(RejectionKind kind, String sentence, @Nullable String commandId) {
        super(sentence, null, false, false);
        this.kind = kind;
        this.commandId = commandId;
    }

    public static Rejection unknown(String what, String id) {
        return new Rejection(RejectionKind.UNKNOWN, "There is no " + what + " " + id + ".");
    }

    public static Rejection forbidden(String sentence) {
        return new Rejection(RejectionKind.FORBIDDEN, sentence);
    }

    public static Rejection notSignedIn(String sentence) {
        return new Rejection(RejectionKind.NOT_SIGNED_IN, sentence);
    }

    /** There was a session, which is no longer known. */
    public static Rejection sessionEnded() {
        return new Rejection(
                RejectionKind.SESSION_ENDED,
                "This session has ended: after 12 hours, or because the account was changed or the stored data were"
                        + " restored. Sign in again.");
    }

    public static Rejection conflict(String sentence) {
        return new Rejection(RejectionKind.CONFLICT, sentence);
    }

    public static Rejection malformed(String sentence) {
        return new Rejection(RejectionKind.MALFORMED, sentence);
    }

    /** A command that the gate refused; its record can be looked up. */
    public static Rejection refused(String sentence, String commandId) {
        return new Rejection(RejectionKind.CONFLICT, sentence, commandId);
    }

    public RejectionKind kind() {
        return kind;
    }

    public @Nullable String commandId() {
        return commandId;
    }

    /** The sentence for people. */
    public String sentence() {
        String message = getMessage();
        return message == null ? kind.title() : message;
    }
}
