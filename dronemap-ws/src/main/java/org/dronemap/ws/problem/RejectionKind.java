package org.dronemap.ws.problem;

/** Classes of rejections, each with its HTTP status and code. */
public enum RejectionKind {
    MALFORMED(400, "malformed", "The request cannot be read"),
    NOT_SIGNED_IN(401, "not-signed-in", "Not signed in"),
    SESSION_ENDED(401, "session-ended", "The session has ended"),
    FORBIDDEN(403, "forbidden", "Not allowed"),
    UNKNOWN(404, "unknown", "There is no such thing"),
    METHOD(405, "method", "Not with this method"),
    TOO_SLOW(408, "too-slow", "Too slow"),
    CONFLICT(409, "refused", "Refused"),
    TOO_LARGE(413, "too-large", "Too large"),
    MEDIA_TYPE(415, "media-type", "Wrong kind of content"),
    INVALID(422, "invalid-value", "A value is missing or out of range"),
    THROTTLED(429, "throttled", "Too many attempts"),
    BROKEN(500, "internal", "The server failed"),
    UNAVAILABLE(503, "unavailable", "Not possible at the moment");

    private final int status;
    private final String code;
    private final String title;

    RejectionKind(int status, String code, String title) {
        this.status = status;
        this.code = code;
        this.title = title;
    }

    public int status() {
        return status;
    }

    public String code() {
        return code;
    }

    public String title() {
        return title;
    }
}
