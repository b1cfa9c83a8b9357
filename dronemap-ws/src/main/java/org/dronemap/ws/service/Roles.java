package org.dronemap.ws.service;

import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;

/** What each role is told when it asks for more than it may. */
final class Roles {
    static final String MAY_LOOK_NOT_COMMAND =
            "Your role may look, not command; ask an administrator for the operator role.";

    private Roles() {}

    static void require(Principal principal, Role needed) {
        if (!principal.may(needed)) {
            throw Rejection.forbidden(
                    needed == Role.OPERATOR
                            ? MAY_LOOK_NOT_COMMAND
                            : "Only an administrator may do this; you are signed in as "
                                    + WireNames.camel(principal.role()) + ".");
        }
    }
}
