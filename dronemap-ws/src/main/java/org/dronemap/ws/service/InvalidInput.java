package org.dronemap.ws.service;

/** A value that cannot be used, with the field it stands in and what is allowed there. */
public final class InvalidInput extends Rejection {
    private static final long serialVersionUID = 1L;

    private final String field;
    private final String allowed;

    public InvalidInput(String field, String allowed, String sentence) {
        super(RejectionKind.INVALID, sentence);
        this.field = field;
        this.allowed = allowed;
    }

    public static InvalidInput missing(String field, String allowed) {
        return new InvalidInput(field, allowed, "\"" + field + "\" is missing; it must be " + allowed + ".");
    }

    public static InvalidInput outside(String field, String allowed, Object value) {
        return new InvalidInput(field, allowed, "\"" + field + "\" must be " + allowed + ", not " + value + ".");
    }

    /** Places too far apart, or zones with too many corners. */
    static InvalidInput unplannable(IllegalArgumentException why) {
        return new InvalidInput(
                "waypoints", "places that can be planned", "This cannot be planned: " + why.getMessage() + ".");
    }

    public String field() {
        return field;
    }

    public String allowed() {
        return allowed;
    }
}
