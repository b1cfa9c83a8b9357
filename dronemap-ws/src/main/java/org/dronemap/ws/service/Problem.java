package org.dronemap.ws.service;

import com.fasterxml.jackson.annotation.JsonInclude;
import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/** A rejection as clients see it (RFC 9457). */
@JsonInclude(JsonInclude.Include.NON_NULL)
@Schema(
        name = "Problem",
        description = "Why a request was not carried out (RFC 9457); the detail is a sentence for people.")
public record Problem(
        @Schema(requiredMode = Schema.RequiredMode.REQUIRED) String type,

        @Schema(requiredMode = Schema.RequiredMode.REQUIRED) String title,

        @Schema(requiredMode = Schema.RequiredMode.REQUIRED) int status,

        @Schema(requiredMode = Schema.RequiredMode.REQUIRED) String detail,

        @Nullable String field,
        @Nullable String allowed,
        @Nullable String commandId,
        @Nullable String holder,
        @Nullable Instant heldSince,
        @Nullable Long retryAfterSeconds) {

    private static final int LONGEST_TEXT = 1_000;

    /** A client's own words come back in a problem: not all of them. */
    public Problem {
        detail = shortened(detail);
        field = field == null ? null : shortened(field);
        allowed = allowed == null ? null : shortened(allowed);
    }

    /** At most 1,000 characters of what a client may have written. */
    public static String shortened(String text) {
        return text.length() <= LONGEST_TEXT ? text : text.substring(0, LONGEST_TEXT - 1) + "…";
    }

    public static Problem of(Rejection rejection) {
        RejectionKind kind = rejection.kind();
        String field = rejection instanceof InvalidInput input ? input.field() : null;
        String allowed = rejection instanceof InvalidInput input ? input.allowed() : null;
        return new Problem(
                "urn:dronemap:problem:" + kind.code(),
                kind.title(),
                kind.status(),
                rejection.sentence(),
                field,
                allowed,
                rejection.commandId(),
                rejection.holder(),
                rejection.heldSince(),
                rejection instanceof Throttled throttled ? (Long) throttled.retryAfterSeconds() : null);
    }

    /** For who knows no more than the status of HTTP. */
    public static Problem ofStatus(int status) {
        return Arrays.stream(RejectionKind.values())
                .filter(kind -> kind.status() == status && kind != RejectionKind.BROKEN)
                .findFirst()
                .map(kind -> of(new Rejection(kind, kind.title() + ".")))
                .orElseGet(
                        () -> status < 500 ? of(Rejection.malformed("The request cannot be understood.")) : internal());
    }

    /** Our own fault: logged where it happened, told without its inside. */
    public static Problem internal() {
        return of(new Rejection(
                RejectionKind.BROKEN, "Something went wrong inside the server; its log has the details."));
    }
}
