package org.dronemap.ws.access;

import java.util.List;
import org.dronemap.ws.budget.WorkKind;

/**
 * Cost of a request in rate-limit budgets: the caller's, or those of the client's address where no sign-in is needed.
 */
public enum RequestCost {
    REQUEST,
    /** Files, exports, backups and replays: a request, and an export. */
    EXPORT,
    SIGN_IN,
    /** Commands have a budget of their own, and control must never be lost for want of one. */
    NOTHING;

    public List<WorkKind> work() {
        return switch (this) {
            case REQUEST -> List.of(WorkKind.REQUEST);
            case EXPORT -> List.of(WorkKind.REQUEST, WorkKind.EXPORT);
            case SIGN_IN -> List.of(WorkKind.SIGN_IN);
            case NOTHING -> List.of();
        };
    }
}
