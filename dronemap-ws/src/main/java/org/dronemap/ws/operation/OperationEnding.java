package org.dronemap.ws.operation;

import org.dronemap.core.access.Principal;

/** Ends operations of one kind for a user who takes their drones over, as that user would by hand. Any thread. */
@FunctionalInterface
public interface OperationEnding {
    /**
     * Ends it, if it is one of this kind; what this user may not end, or is over, is refused as by hand.
     *
     * @param id of any operation
     */
    void end(Principal principal, String id);
}
