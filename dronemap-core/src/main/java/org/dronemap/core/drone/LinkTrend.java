package org.dronemap.core.drone;

import org.jspecify.annotations.Nullable;

/**
 * Trend of a vehicle's link, compared with how that link usually is.
 *
 * @param secondsLeft about so long until it is lost, if it goes on so; null: it gets no worse now, or that is not known
 * @param words what is seen, as a sentence
 */
public record LinkTrend(State state, @Nullable Integer secondsLeft, String words) {
    public static final LinkTrend UNKNOWN =
            new LinkTrend(State.UNKNOWN, null, "How this link usually is, is not known yet.");

    /** Direction in which a link's quality goes. */
    public enum State {
        /** It was not heard for long, or speaks too seldom to tell. */
        UNKNOWN,
        /** As it usually is. */
        STEADY,
        /** Worse than it usually is. */
        WORSE,
        /** It gets worse so quickly that it is expected to be lost soon. */
        FALLING
    }

    /** It is expected to be lost soon. */
    public boolean isFalling() {
        return state == State.FALLING;
    }
}
