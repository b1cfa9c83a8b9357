package org.dronemap.ws.operation;

import java.util.Optional;
import org.dronemap.core.access.Principal;

/** Users whom operations are conducted for, with what they may do now. Any thread. */
@FunctionalInterface
public interface OperationOwners {
    /** Empty: nothing. */
    Optional<Principal> find(String account);
}
