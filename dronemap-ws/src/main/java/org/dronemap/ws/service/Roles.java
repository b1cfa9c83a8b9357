package org.dronemap.ws.service;

import java.util.Arrays;
import java.util.Map;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.jspecify.annotations.Nullable;

/** What each role is told when it asks for more than it may, and what roles are called. */
public final class Roles {
    private static final String NAMES = "administrator, supervisor, operator, planner, viewer or reporter";
    private static final Map<Role, String> REFUSALS = Map.of(
            Role.VIEWER, "Your role may send reports, not see drones; ask an administrator for the viewer role.",
            Role.PLANNER, "Your role may look, not command; ask an administrator for the operator role.",
            Role.OPERATOR, "Your role may look, not command; ask an administrator for the operator role.");

    private Roles() {}

    public static void require(Principal principal, Role needed) {
        if (!principal.may(needed)) {
            if (principal.role().includes(needed)) {
                throw Rejection.forbidden("This access key may only " + verbs(principal) + "; make one that may more.");
            }
            throw Rejection.forbidden(REFUSALS.getOrDefault(
                    needed,
                    "Only " + article(needed) + " may do this; you are signed in as "
                            + WireNames.camel(principal.role()) + "."));
        }
    }

    /** For what concerns no drone by itself, or all of them. */
    public static void requireForAll(Principal principal, Role needed) {
        require(principal, needed);
        if (!principal.scope().coversAllDrones()) {
            throw Rejection.forbidden("This access key is for certain drones only, and this concerns all of them.");
        }
    }

    private static String verbs(Principal principal) {
        return String.join(
                " and ",
                principal.scope().permissions().stream().map(WireNames::camel).toList());
    }

    static Role named(@Nullable String text) {
        if (text == null) {
            throw InvalidInput.missing("role", NAMES);
        }
        return Arrays.stream(Role.values())
                .filter(role -> WireNames.camel(role).equals(text))
                .findFirst()
                .orElseThrow(() -> InvalidInput.outside("role", NAMES, "\"" + text + "\""));
    }

    private static String article(Role role) {
        return (role == Role.ADMINISTRATOR ? "an " : "a ") + WireNames.camel(role);
    }
}
