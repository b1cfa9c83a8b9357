package org.dronemap.ws.access;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The access rule for one request: the level of caller it needs, its cost and its audit policy.
 *
 * @param operation what it is dispatched to; null: there is nothing at the address, it does not take the method, or REST does
 *     not have it
 */
public record AccessRule(
        AccessLevel from,
        RequestCost costs,
        AuditPolicy audit,
        @Nullable RestOperation operation) {
    static AccessRule of(RestOperation operation) {
        Access access = operation.access();
        return new AccessRule(access.from(), access.costs(), operation.audit(), operation);
    }

    /**
     * For a request that no handler takes: who may not look learns nothing of addresses. {@code others} are what the address
     * takes by other methods; where all of it is open, so is the answer that this method is not taken.
     */
    static AccessRule withoutHandler(String method, List<RestOperation> others) {
        AccessLevel strictest = others.stream()
                .map(operation -> operation.access().from())
                .reduce((one, other) -> one.compareTo(other) > 0 ? one : other)
                .orElse(AccessLevel.VIEWER);
        AccessLevel from = strictest.compareTo(AccessLevel.VIEWER) > 0 ? AccessLevel.VIEWER : strictest;
        RequestCost costs = from == AccessLevel.ANYBODY ? others.get(0).access().costs() : RequestCost.REQUEST;
        return new AccessRule(from, costs, AuditPolicy.BY_METHOD.of(method), null);
    }
}
