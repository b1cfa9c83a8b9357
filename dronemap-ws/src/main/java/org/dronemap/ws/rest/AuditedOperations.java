package org.dronemap.ws.rest;

import jakarta.servlet.http.HttpServletRequest;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.dronemap.ws.service.AuditNotes;
import org.jspecify.annotations.Nullable;
import org.springframework.http.server.PathContainer;
import org.springframework.web.servlet.mvc.method.RequestMappingInfo;
import org.springframework.web.servlet.mvc.method.annotation.RequestMappingHandlerMapping;
import org.springframework.web.util.pattern.PathPattern;

/** Says what an address stands for before anything is done about a request, also for those who are turned away at once. */
public final class AuditedOperations {
    private static final String OF_DRONE = "/api/v1/drones/{id}";

    private final Supplier<RequestMappingHandlerMapping> dispatcher;
    private @Nullable List<Known> known;

    private record Known(String method, PathPattern pattern) {}

    /** {@code name}: as the table of who may do what has it. */
    record Operation(String name, @Nullable String drone, String parameters) {}

    public AuditedOperations(Supplier<RequestMappingHandlerMapping> dispatcher) {
        this.dispatcher = dispatcher;
    }

    Operation of(HttpServletRequest request) {
        PathContainer path = PathContainer.parsePath(request.getRequestURI());
        return known().stream()
                .filter(one -> one.method().equals(request.getMethod())
                        && one.pattern().matches(path))
                .findFirst()
                .map(one -> operation(one, path))
                .orElseGet(() -> new Operation(request.getMethod() + " (no such address)", null, ""));
    }

    private static Operation operation(Known known, PathContainer path) {
        String pattern = known.pattern().getPatternString();
        PathPattern.PathMatchInfo match = known.pattern().matchAndExtract(path);
        Map<String, String> variables = match == null ? Map.of() : match.getUriVariables();
        boolean ofDrone = pattern.equals(OF_DRONE) || pattern.startsWith(OF_DRONE + "/");
        String parameters = variables.entrySet().stream()
                .filter(one -> !ofDrone || !one.getKey().equals("id"))
                .map(one -> one.getKey() + "=" + AuditNotes.told(one.getValue()))
                .collect(Collectors.joining(", "));
        String drone = ofDrone ? variables.get("id") : null;
        return new Operation(known.method() + " " + pattern, drone == null ? null : AuditNotes.told(drone), parameters);
    }

    /** The most specific first. */
    private synchronized List<Known> known() {
        List<Known> made = known;
        if (made == null) {
            made = dispatcher.get().getHandlerMethods().keySet().stream()
                    .flatMap(mapping -> of(mapping).stream())
                    .sorted(Comparator.comparing(Known::pattern))
                    .toList();
            known = made;
        }
        return made;
    }

    private static List<Known> of(RequestMappingInfo mapping) {
        var patterns = mapping.getPathPatternsCondition();
        return patterns == null
                ? List.of()
                : patterns.getPatterns().stream()
                        .flatMap(pattern -> mapping.getMethodsCondition().getMethods().stream()
                                .map(method -> new Known(method.name(), pattern)))
                        .toList();
    }
}
