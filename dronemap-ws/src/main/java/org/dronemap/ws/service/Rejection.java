package org.dronemap.ws.service;

import java.time.Instant;
import java.time.temporal.ChronoUnit;
import org.dronemap.core.lease.Control;
import org.dronemap.core.lease.Tenure;
import org.jspecify.annotations.Nullable;

/** A request that is answered with a sentence instead of being carried out; each face maps it to its own form. */
public class Rejection extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final RejectionKind kind;
    private final @Nullable String commandId;
    private final @Nullable String holder;
    private final @Nullable Instant heldSince;

    public Rejection(RejectionKind kind, String sentence) {
        this(kind, sentence, null, null);
    }

    private Rejection(RejectionKind kind, String sentence, @Nullable String commandId, @Nullable Tenure tenure) {
        super(sentence, null, false, false);
        this.kind = kind;
        this.commandId = commandId;
        this.holder = tenure == null ? null : ControlView.name(tenure.holder());
        this.heldSince = tenure == null ? null : tenure.since().truncatedTo(ChronoUnit.MILLIS);
    }

    /** Somebody else has control; {@code commandId} of the refused command, null where it was none. */
    public static Rejection held(String sentence, @Nullable String commandId, Control control) {
        return new Rejection(RejectionKind.CONFLICT, sentence, commandId, control.tenure());
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
        return new Rejection(RejectionKind.CONFLICT, sentence, commandId, null);
    }

    public RejectionKind kind() {
        return kind;
    }

    public @Nullable String commandId() {
        return commandId;
    }

    /** The user who has control; null where that is not why, or nobody has. */
    public @Nullable String holder() {
        return holder;
    }

    /** Since when somebody has control; null where that is not why. */
    public @Nullable Instant heldSince() {
        return heldSince;
    }

    /** The sentence for people. */
    public String sentence() {
        String message = getMessage();
        return message == null ? kind.title() : message;
    }
}
