package org.dronemap.ws.problem;

import com.fasterxml.jackson.annotation.JsonInclude;
import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;

/** A refused request as REST clients see it: a problem document (RFC 9457) with code and sentence. */
@JsonInclude(JsonInclude.Include.NON_NULL)
@Schema(
        name = "Problem",
        description = "Why a request was not carried out (RFC 9457); the detail is a sentence for people.")
public record ProblemView(
        @Schema(requiredMode = Schema.RequiredMode.REQUIRED) String type,

        @Schema(requiredMode = Schema.RequiredMode.REQUIRED) String title,

        @Schema(requiredMode = Schema.RequiredMode.REQUIRED) int status,

        @Schema(requiredMode = Schema.RequiredMode.REQUIRED) String detail,

        @Schema(
                requiredMode = Schema.RequiredMode.REQUIRED,
                description = "Why exactly, for programs; docs/problems.md lists them")
        String code,

        @Schema(
                requiredMode = Schema.RequiredMode.REQUIRED,
                description = "What the detail is about; which of them come with which code, docs/problems.md tells")
        Map<String, Object> parameters,

        @Nullable String field,
        @Nullable String allowed,
        @Nullable String commandId,
        @Nullable String holder,
        @Nullable Instant heldSince,
        @Nullable Long retryAfterSeconds) {

    private static final int LONGEST_TEXT = 1_000;

    /** What the web server itself answers with, before anything of ours is asked. */
    private static final List<ProblemCode> BY_STATUS = List.of(
            RequestProblem.REQUEST_UNREADABLE,
            AccessProblem.SIGN_IN_NEEDED,
            AccessProblem.REQUEST_FORBIDDEN,
            RequestProblem.ADDRESS_UNKNOWN,
            RequestProblem.METHOD_NOT_TAKEN,
            RequestProblem.BODY_TOO_SLOW,
            RequestProblem.BODY_TOO_LARGE,
            RequestProblem.CONTENT_TYPE_NOT_TAKEN,
            ServerProblem.NOT_AVAILABLE);

    /** A client's own words come back in a problem: not all of them. */
    public ProblemView {
        detail = shortened(detail);
        field = field == null ? null : shortened(field);
        allowed = allowed == null ? null : shortened(allowed);
    }

    /** At most 1,000 characters of what a client may have written. */
    public static String shortened(String text) {
        return text.length() <= LONGEST_TEXT ? text : text.substring(0, LONGEST_TEXT - 1) + "…";
    }

    public static ProblemView of(Rejection rejection) {
        RejectionKind kind = rejection.kind();
        String field = rejection instanceof InvalidInput input ? input.field() : null;
        String allowed = rejection instanceof InvalidInput input ? input.allowed() : null;
        return new ProblemView(
                "urn:dronemap:problem:" + kind.code(),
                kind.title(),
                kind.status(),
                rejection.sentence(),
                rejection.code().word(),
                values(rejection),
                field,
                allowed,
                rejection.commandId(),
                rejection.holder(),
                rejection.heldSince(),
                rejection instanceof RateLimitRejection throttled ? (Long) throttled.retryAfterSeconds() : null);
    }

    /** In the order of their names. */
    public static Map<String, Object> values(Rejection rejection) {
        Map<String, Object> values = new TreeMap<>();
        rejection.parameters().forEach(given -> values.put(given.parameter().word(), given.value()));
        return Collections.unmodifiableMap(values);
    }

    /** For who knows no more than the status of HTTP. */
    public static ProblemView ofStatus(int status) {
        return BY_STATUS.stream()
                .filter(code -> code.kind().status() == status)
                .findFirst()
                .map(code -> of(Rejection.of(code, code.kind().title() + ".")))
                .orElseGet(() -> status < 500
                        ? of(Rejection.of(RequestProblem.REQUEST_UNREADABLE, "The request cannot be understood."))
                        : internal());
    }

    /** Our own fault: logged where it happened, told without its inside. */
    public static ProblemView internal() {
        return of(Rejection.of(
                ServerProblem.SERVER_FAILED, "Something went wrong inside the server; its log has the details."));
    }
}
