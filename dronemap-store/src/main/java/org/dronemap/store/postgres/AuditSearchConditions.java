package org.dronemap.store.postgres;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.audit.AuditQuery;
import org.jspecify.annotations.Nullable;

/**
 * The SQL condition of an audit search: {@code r} is a call's record, {@code e} the one that ends it (null: none yet).
 */
final class AuditSearchConditions {
    private final StringBuilder text = new StringBuilder("r.ends IS NULL");
    private final List<Object> arguments = new ArrayList<>();

    AuditSearchConditions(AuditQuery query, long before) {
        and("r.sequence < ?", before);
        and("r.account_name = ?", query.user());
        and("r.organisation_id = ?", query.organisation());
        and("r.drone_id = ?", query.drone());
        and("r.face = ?", query.face());
        and("position(lower(?) IN lower(r.operation)) > 0", query.operation());
        and("coalesce(e.outcome, r.outcome) = ?", query.outcome());
        and("r.happened_at >= ?", query.from());
        and("r.happened_at < ?", query.until());
    }

    private void and(String condition, @Nullable Object wanted) {
        if (wanted != null) {
            text.append(" AND ").append(condition);
            arguments.add(wanted);
        }
    }

    String text() {
        return text.toString();
    }

    Object[] arguments() {
        return arguments.toArray();
    }
}
