package org.dronemap.ws.stream;

import com.fasterxml.jackson.annotation.JsonInclude;
import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import org.dronemap.core.access.Role;
import org.dronemap.ws.problem.ProblemView;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.ObjectOnlyTypeResolver;
import org.jspecify.annotations.Nullable;
import org.springframework.core.Ordered;
import org.springframework.core.annotation.Order;
import tools.jackson.databind.annotation.JsonTypeResolver;

/** A message that the server sends to clients on the WebSocket stream; {@link Order} is its place in the description. */
@JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "type")
@JsonTypeResolver(ObjectOnlyTypeResolver.class)
@JsonSubTypes({
    @JsonSubTypes.Type(value = StreamMessage.Hello.class, name = "hello"),
    @JsonSubTypes.Type(value = StreamMessage.Failure.class, name = "error"),
    @JsonSubTypes.Type(value = StreamMessage.Ping.class, name = "ping"),
    @JsonSubTypes.Type(value = StreamMessage.Pong.class, name = "pong")
})
@Schema(name = "StreamMessage", description = "What the server says.")
public sealed interface StreamMessage {
    /** A message that is declared beside its use case; {@code @JsonTypeName} says its type. */
    non-sealed interface OfUseCase extends StreamMessage {}

    @Order(Ordered.HIGHEST_PRECEDENCE)
    @Schema(name = "StreamHello", description = "The first message: who you are, and the version of the server.")
    record Hello(String user, @EnumValues(Role.class) String role, String version) implements StreamMessage {}

    @Order
    @JsonInclude(JsonInclude.Include.NON_NULL)
    @Schema(
            name = "StreamError",
            description = "Answers a request that is not carried out, or says why the connection is closed.")
    record Failure(ProblemView problem, @Nullable String requestId) implements StreamMessage {}

    @Order
    @Schema(name = "StreamPing", description = "The sign of life, once a second, by the clock of the cloud.")
    record Ping(Instant at) implements StreamMessage {}

    @Order
    @Schema(name = "StreamPong", description = "Answers ping.")
    record Pong() implements StreamMessage {}
}
