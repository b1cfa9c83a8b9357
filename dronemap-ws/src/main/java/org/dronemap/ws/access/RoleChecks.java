package org.dronemap.ws.access;

import java.util.Arrays;
import java.util.Map;
import org.dronemap.core.access.Permission;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneId;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/** Checks for the services that a caller has the role an operation needs, and rejects the request otherwise. */
public final class RoleChecks {
    private static final String NAMES = "administrator, supervisor, operator, planner, viewer or reporter";
    private static final Map<Role, String> REFUSALS = Map.of(
            Role.VIEWER, "Your role may send reports, not see drones; ask an administrator for the viewer role.",
            Role.PLANNER, "Your role may look, not command; ask an administrator for the operator role.",
            Role.OPERATOR, "Your role may look, not command; ask an administrator for the operator role.");

    private static final String NOT_GRANTED = "You were not granted to do this; ask an administrator for a grant.";

    private RoleChecks() {}

    /** By the role alone: what keys and grants leave of it hangs on what it is for. */
    public static void requireRole(Principal principal, Role needed) {
        if (!principal.role().includes(needed)) {
            throw lacking(principal, needed);
        }
    }

    public static void require(Principal principal, Role needed) {
        if (!principal.may(needed)) {
            throw lacking(principal, needed);
        }
    }

    /** With that drone, which the asker sees. */
    public static void require(Principal principal, Role needed, DroneId drone) {
        if (!principal.may(needed, drone)) {
            throw lacking(principal, needed);
        }
    }

    private static Rejection lacking(Principal principal, Role needed) {
        if (!principal.role().includes(needed)) {
            return Rejection.of(
                    AccessProblem.ROLE_TOO_LOW,
                    REFUSALS.getOrDefault(
                            needed,
                            "Only " + article(needed) + " may do this; you are signed in as "
                                    + WireNames.camel(principal.role()) + "."),
                    ProblemParameter.NEEDED.is(WireNames.camel(needed)),
                    ProblemParameter.ROLE.is(WireNames.camel(principal.role())));
        }
        Permission permission = needed.permission();
        if (permission != null && !principal.scope().permissions().contains(permission)) {
            return Rejection.of(
                    AccessProblem.KEY_MAY_LESS,
                    "This access key may only " + verbs(principal) + "; make one that may more.",
                    ProblemParameter.NEEDED.is(WireNames.camel(needed)));
        }
        return Rejection.of(AccessProblem.NOT_GRANTED, NOT_GRANTED);
    }

    /** For what concerns no drone by itself, or all of them. */
    public static void requireForAll(Principal principal, Role needed) {
        require(principal, needed);
        if (!principal.scope().coversAllDrones()) {
            throw Rejection.of(
                    AccessProblem.KEY_FOR_SOME_DRONES,
                    "This access key is for certain drones only, and this concerns all of them.");
        }
        // Who may make users, or zones, would get round any bounds.
        if (principal.scope().isBounded() && needed.includes(Role.PLANNER)) {
            throw Rejection.of(
                    AccessProblem.KEY_BOUNDED,
                    "This access key has an area or heights, and what has none is closed to it.");
        }
        if (!principal.isWhole()) {
            throw Rejection.of(
                    AccessProblem.SEES_NOT_ALL, "You see only what you were granted, and this concerns all drones.");
        }
    }

    /** For what belongs to no organisation: links, what waits at them, the data as a whole. */
    public static void requireServer(Principal principal, Role needed) {
        requireForAll(principal, needed);
        if (!principal.organisation().isHome()) {
            throw Rejection.of(AccessProblem.SERVER_ONLY, "This concerns the whole server; ask those who run it.");
        }
    }

    private static String verbs(Principal principal) {
        return String.join(
                " and ",
                principal.scope().permissions().stream().map(WireNames::camel).toList());
    }

    public static Role named(@Nullable String text) {
        if (text == null) {
            throw InvalidInput.missing("role", NAMES);
        }
        return Arrays.stream(Role.values())
                .filter(role -> WireNames.camel(role).equals(text))
                .findFirst()
                .orElseThrow(
                        () -> InvalidInput.outside(ValueProblem.VALUE_NOT_ALLOWED, "role", NAMES, "\"" + text + "\""));
    }

    private static String article(Role role) {
        return (role == Role.ADMINISTRATOR ? "an " : "a ") + WireNames.camel(role);
    }
}
