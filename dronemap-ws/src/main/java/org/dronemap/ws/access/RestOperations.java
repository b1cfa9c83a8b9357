package org.dronemap.ws.access;

import io.swagger.v3.oas.annotations.Operation;
import jakarta.servlet.http.HttpServletRequest;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.springframework.beans.factory.SmartInitializingSingleton;
import org.springframework.core.annotation.AnnotatedElementUtils;
import org.springframework.http.server.PathContainer;
import org.springframework.web.bind.annotation.RequestMethod;
import org.springframework.web.method.HandlerMethod;
import org.springframework.web.servlet.mvc.method.RequestMappingInfo;
import org.springframework.web.util.pattern.PathPattern;

/**
 * All operations of the REST API with their access rules, and the lookup of the one that a request addresses. Asked by
 * the filters, so before it is known who sends the request. Any thread.
 */
public final class RestOperations implements SmartInitializingSingleton {
    /** Describes the faces to anybody; its handlers are not ours. */
    private static final String DESCRIPTION = "org.springdoc.";

    private static final String RULE = AccessRule.class.getName();

    private final Supplier<Map<RequestMappingInfo, HandlerMethod>> handlers;
    /** Null until it is asked for. */
    private volatile @Nullable List<RestOperation> known;

    /** {@code handlers}: asked when there are all of them. */
    public RestOperations(Supplier<Map<RequestMappingInfo, HandlerMethod>> handlers) {
        this.handlers = handlers;
    }

    /** Before the server listens: the start fails where a handler does not say who may call it. */
    @Override
    public void afterSingletonsInstantiated() {
        all();
    }

    /** The most specific address first. */
    public List<RestOperation> all() {
        List<RestOperation> made = known;
        if (made == null) {
            made = handlers.get().entrySet().stream()
                    .filter(entry -> !entry.getValue().getBeanType().getName().startsWith(DESCRIPTION))
                    .flatMap(entry -> operations(entry.getKey(), entry.getValue()))
                    .sorted(Comparator.comparing(RestOperation::pattern))
                    .toList();
            known = made;
        }
        return made;
    }

    private static Stream<RestOperation> operations(RequestMappingInfo mapping, HandlerMethod handler) {
        Access access = AnnotatedElementUtils.findMergedAnnotation(handler.getMethod(), Access.class);
        if (access == null) {
            throw new IllegalStateException(
                    "The handler " + handler.getBeanType().getName() + "."
                            + handler.getMethod().getName()
                            + " has no @Access; say there who may call it, and what it is about.");
        }
        Operation described = AnnotatedElementUtils.findMergedAnnotation(handler.getMethod(), Operation.class);
        String id = described == null ? null : described.operationId();
        var patterns = mapping.getPathPatternsCondition();
        Set<PathPattern> addresses = patterns == null ? Set.of() : patterns.getPatterns();
        return addresses.stream()
                .flatMap(pattern -> methods(mapping).map(method -> new RestOperation(id, method, pattern, access)));
    }

    /** One that names none takes all of them. */
    private static Stream<String> methods(RequestMappingInfo mapping) {
        Set<RequestMethod> named = mapping.getMethodsCondition().getMethods();
        return (named.isEmpty() ? Stream.of(RequestMethod.values()) : named.stream()).map(RequestMethod::name);
    }

    /** The rule for the request; worked out once. */
    public AccessRule rule(HttpServletRequest request) {
        if (request.getAttribute(RULE) instanceof AccessRule rule) {
            return rule;
        }
        AccessRule rule = find(request.getMethod(), PathContainer.parsePath(request.getRequestURI()));
        request.setAttribute(RULE, rule);
        return rule;
    }

    /** The rule for what another face has done as the operation with that id. */
    public AccessRule rule(String id) {
        return all().stream()
                .filter(operation -> id.equals(operation.id()))
                .findFirst()
                .map(AccessRule::of)
                .orElseThrow(() -> new IllegalArgumentException("There is no operation of REST called " + id + "."));
    }

    private AccessRule find(String method, PathContainer path) {
        // As the dispatcher has it, which answers HEAD by what answers GET.
        String taken = method.equals("HEAD") ? "GET" : method;
        return all().stream()
                .filter(operation ->
                        operation.method().equals(taken) && operation.pattern().matches(path))
                .findFirst()
                .map(AccessRule::of)
                .orElseGet(() -> AccessRule.withoutHandler(method, at(path)));
    }

    private List<RestOperation> at(PathContainer path) {
        return all().stream()
                .filter(operation -> operation.pattern().matches(path))
                .toList();
    }
}
