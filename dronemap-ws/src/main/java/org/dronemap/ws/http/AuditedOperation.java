package org.dronemap.ws.http;

import jakarta.servlet.http.HttpServletRequest;
import java.util.Map;
import java.util.stream.Collectors;
import org.dronemap.ws.access.AuditNotes;
import org.dronemap.ws.access.RestOperation;
import org.jspecify.annotations.Nullable;
import org.springframework.http.server.PathContainer;
import org.springframework.web.util.pattern.PathPattern;

/**
 * Entry of an HTTP request for the audit log: operation name, drone and parameters, known before the request runs.
 *
 * @param name as the table of who may do what has it
 */
record AuditedOperation(String name, @Nullable String drone, String parameters) {
    private static final String OF_DRONE = "/api/v1/drones/{id}";

    /** {@code operation}: null, no handler takes the request. */
    static AuditedOperation of(HttpServletRequest request, @Nullable RestOperation operation) {
        if (operation == null) {
            return new AuditedOperation(request.getMethod() + " (no such address)", null, "");
        }
        String pattern = operation.pattern().getPatternString();
        PathPattern.PathMatchInfo match =
                operation.pattern().matchAndExtract(PathContainer.parsePath(request.getRequestURI()));
        Map<String, String> variables = match == null ? Map.of() : match.getUriVariables();
        boolean ofDrone = pattern.equals(OF_DRONE) || pattern.startsWith(OF_DRONE + "/");
        String parameters = variables.entrySet().stream()
                .filter(one -> !ofDrone || !one.getKey().equals("id"))
                .map(one -> one.getKey() + "=" + AuditNotes.withoutSecrets(one.getValue()))
                .collect(Collectors.joining(", "));
        String drone = ofDrone ? variables.get("id") : null;
        return new AuditedOperation(
                operation.name(), drone == null ? null : AuditNotes.withoutSecrets(drone), parameters);
    }
}
