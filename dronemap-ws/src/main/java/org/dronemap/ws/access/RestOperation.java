package org.dronemap.ws.access;

import org.jspecify.annotations.Nullable;
import org.springframework.web.util.pattern.PathPattern;

/**
 * One operation of the REST API: its method, its address pattern and the {@link Access} that its handler declares.
 *
 * @param id as the description of REST calls it; null: it has no description
 */
public record RestOperation(@Nullable String id, String method, PathPattern pattern, Access access) {
    /** As the table of who may do what has it. */
    public String name() {
        return method + " " + pattern.getPatternString();
    }

    public AuditPolicy audit() {
        return access.audit().of(method);
    }
}
