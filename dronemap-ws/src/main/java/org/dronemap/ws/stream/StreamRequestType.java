package org.dronemap.ws.stream;

import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;
import org.dronemap.ws.access.AccessRule;
import org.jspecify.annotations.Nullable;

/**
 * Type of a request on the WebSocket stream: its record, its access rule and its answer.
 *
 * @param request the record, or the interface of its records where one more member tells them apart
 * @param access without one there is no such type
 * @param reply null when only a refusal is answered
 */
public record StreamRequestType<R extends StreamRequest>(
        Class<R> request,
        StreamAccessRule<R> access,
        @Nullable Class<? extends StreamMessage> reply) {
    public StreamRequestType {
        Objects.requireNonNull(access, () -> request.getName() + " has no access rule: say who may send it.");
    }

    /** How it is answered when it is carried out. */
    public Optional<Class<? extends StreamMessage>> answer() {
        return Optional.ofNullable(reply);
    }

    /** {@code rest}: finds the rule of an operation of REST. */
    AccessRule rule(StreamRequest one, Function<String, AccessRule> rest) {
        return access.of(request.cast(one), rest);
    }
}
