package org.dronemap.ws.openapi;

import io.swagger.v3.oas.models.Operation;
import io.swagger.v3.oas.models.media.Content;
import io.swagger.v3.oas.models.media.MediaType;
import io.swagger.v3.oas.models.media.Schema;
import io.swagger.v3.oas.models.responses.ApiResponse;
import io.swagger.v3.oas.models.responses.ApiResponses;
import jakarta.servlet.ServletRequest;
import jakarta.servlet.ServletResponse;
import java.lang.annotation.Annotation;
import java.util.Arrays;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.http.FileMediaTypes;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.problem.ProblemView;
import org.jspecify.annotations.Nullable;
import org.springdoc.core.customizers.OperationCustomizer;
import org.springframework.core.MethodParameter;
import org.springframework.http.HttpStatus;
import org.springframework.web.bind.annotation.DeleteMapping;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.method.HandlerMethod;

/**
 * Lists in the OpenAPI description the HTTP statuses with which each operation can succeed or be refused. Each refusal
 * is a problem.
 */
public final class StatusCustomizer implements OperationCustomizer {
    private static final int NO_CONTENT = 204;
    private static final int FOUND = 302;

    @Override
    public Operation customize(Operation operation, HandlerMethod handler) {
        ApiResponses responses = operation.getResponses();
        ResponseStatuses answers = handler.getMethodAnnotation(ResponseStatuses.class);
        if (answers != null && answers.value().length > 0) {
            ApiResponse success = responses.values().iterator().next();
            responses.clear();
            for (int status : answers.value()) {
                responses.addApiResponse(String.valueOf(status), success(status, success.getContent()));
            }
        }
        for (int status : refusals(handler)) {
            responses.addApiResponse(String.valueOf(status), refusal(status));
        }
        return operation;
    }

    private static ApiResponse success(int status, @Nullable Content content) {
        boolean empty = status == NO_CONTENT || status == FOUND;
        return new ApiResponse().description(words(status)).content(empty ? null : content);
    }

    private static ApiResponse refusal(int status) {
        Schema<ProblemView> problem = new Schema<>();
        problem.set$ref("#/components/schemas/Problem");
        return new ApiResponse()
                .description(words(status))
                .content(new Content().addMediaType("application/problem+json", new MediaType().schema(problem)));
    }

    private static String words(int status) {
        HttpStatus known = HttpStatus.resolve(status);
        return known == null ? "" : known.getReasonPhrase();
    }

    private static Set<Integer> refusals(HandlerMethod handler) {
        Set<Integer> statuses = new TreeSet<>();
        statuses.add(429);
        statuses.add(503);
        Access access = handler.getMethodAnnotation(Access.class);
        if (access == null || access.from() != AccessLevel.ANYBODY) {
            statuses.add(401);
            statuses.add(403);
        }
        if (hasParameter(handler, PathVariable.class)) {
            statuses.add(404);
        }
        if (gives(handler, parameter -> true)) {
            statuses.add(400);
        }
        // What an address is about is there or not, unless it is a number.
        if (gives(handler, parameter -> !isName(parameter))) {
            statuses.add(422);
        }
        if (hasBody(handler)) {
            statuses.addAll(Arrays.asList(408, 413, 415));
        }
        if (!isMapped(handler, GetMapping.class) && !isMapped(handler, DeleteMapping.class)) {
            statuses.add(409);
        }
        ResponseStatuses answers = handler.getMethodAnnotation(ResponseStatuses.class);
        if (answers != null) {
            Arrays.stream(answers.refuses()).forEach(statuses::add);
            Arrays.stream(answers.never()).forEach(statuses::remove);
        }
        return statuses;
    }

    private static boolean isMapped(HandlerMethod handler, Class<? extends Annotation> how) {
        return handler.getMethodAnnotation(how) != null;
    }

    /** Whether a client gives what is such a parameter; others are the request and the answer themselves. */
    private static boolean gives(HandlerMethod handler, Predicate<MethodParameter> which) {
        return Stream.of(handler.getMethodParameters())
                .filter(parameter -> !ServletRequest.class.isAssignableFrom(parameter.getParameterType())
                        && !ServletResponse.class.isAssignableFrom(parameter.getParameterType()))
                .anyMatch(which);
    }

    private static boolean isName(MethodParameter parameter) {
        return parameter.hasParameterAnnotation(PathVariable.class) && parameter.getParameterType() == String.class;
    }

    private static boolean hasBody(HandlerMethod handler) {
        FileMediaTypes files = handler.getMethodAnnotation(FileMediaTypes.class);
        return hasParameter(handler, RequestBody.class) || (files != null && files.consumes().length > 0);
    }

    private static boolean hasParameter(HandlerMethod handler, Class<? extends Annotation> what) {
        return Stream.of(handler.getMethodParameters()).anyMatch(parameter -> parameter.hasParameterAnnotation(what));
    }
}
