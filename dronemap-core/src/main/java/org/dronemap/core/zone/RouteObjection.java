package org.dronemap.core.zone;

/**
 * Objection to a predicted route: it leads where the drone must not fly, or cannot be checked.
 *
 * @param kind what of it is known
 * @param sentence names the leg, the zone and a distance, or what is not known
 */
public record RouteObjection(Kind kind, String sentence) {
    /** Kinds of objections to a route: forbidden or not checkable. */
    public enum Kind {
        /** It leads where a drone must not be, or changes what may not be changed. */
        FORBIDDEN,
        /** Something is missing without which nobody can tell. */
        NOT_CHECKABLE
    }

    static RouteObjection forbidden(String sentence) {
        return new RouteObjection(Kind.FORBIDDEN, sentence);
    }

    static RouteObjection notCheckable(String sentence) {
        return new RouteObjection(Kind.NOT_CHECKABLE, sentence);
    }
}
