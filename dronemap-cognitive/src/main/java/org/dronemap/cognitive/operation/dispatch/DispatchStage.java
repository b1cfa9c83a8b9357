package org.dronemap.cognitive.operation.dispatch;

import org.dronemap.core.stored.Stored;

/** The stage of a dispatch, which is that of the drone that comes. */
@Stored(names = "CHOSEN STARTING EN_ROUTE ARRIVED HERE SEARCHING RETURNING OVER")
public enum DispatchStage {
    /** A drone is kept for it, on the ground. */
    CHOSEN,
    /** The drone is made ready, armed, and climbs. */
    STARTING,
    EN_ROUTE,
    /** The drone is there, and control goes over to whoever asked. */
    ARRIVED,
    /** The drone is there, and whoever asked has control of it. */
    HERE,
    /** The drone before cannot come, and another one is looked for. */
    SEARCHING,
    /** No drone comes any more, and those that flew for it fly home. */
    RETURNING,
    OVER;

    /** The dispatch needs control of the drone that comes. */
    boolean leads() {
        return switch (this) {
            case CHOSEN, STARTING, EN_ROUTE, ARRIVED -> true;
            case HERE, SEARCHING, RETURNING, OVER -> false;
        };
    }
}
