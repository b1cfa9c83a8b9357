package org.dronemap.core.command;

/** Effect of a command on where its drone would fly later by itself, such as home; checked against flight bounds. */
public enum DeferredEffect {
    NOTHING,
    /** Parameters that say so: nobody knows which way, beforehand. */
    PARAMETERS,
    /** The place that it returns to: a {@link Command.SetHome}. */
    HOME,
    /** The places that it may go to instead of home: a {@link SetRallyPoints}. */
    RALLY_POINTS,
    /** The mode that it flies in, which may find a way of its own: a {@link Command.SetMode}. */
    MODE
}
