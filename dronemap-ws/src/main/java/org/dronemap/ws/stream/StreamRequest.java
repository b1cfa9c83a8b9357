package org.dronemap.ws.stream;

import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import org.dronemap.ws.reading.ObjectOnlyTypeResolver;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.annotation.JsonTypeResolver;

/** A request that a client sends on the WebSocket stream. Nothing is checked yet. */
@JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "type")
@JsonTypeResolver(ObjectOnlyTypeResolver.class)
@JsonSubTypes({
    @JsonSubTypes.Type(value = StreamRequest.Authenticate.class, name = "authenticate"),
    @JsonSubTypes.Type(value = StreamRequest.Subscribe.class, name = "subscribe"),
    @JsonSubTypes.Type(value = StreamRequest.Ping.class, name = "ping")
})
@Schema(name = "StreamRequest", description = "What a client says; which members there are depends on the type.")
public sealed interface StreamRequest {
    /** A request that is declared beside its use case ({@link StreamOperation}); {@code @JsonTypeName} says its type. */
    non-sealed interface OfUseCase extends StreamRequest {}

    /** Comes back with the answer. */
    @Nullable
    String requestId();

    /** The drone that it is about. */
    default @Nullable String drone() {
        return null;
    }

    @Schema(
            name = "StreamAuthenticateRequest",
            description = "Shows an access key, within 5 s, where none came before.")
    record Authenticate(
            @Nullable String requestId,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "An access key") @Nullable
            String key)
            implements StreamRequest {}

    @Schema(name = "StreamSubscribeRequest", description = "Says which drones shall be told of, and how often.")
    record Subscribe(
            @Nullable String requestId,

            @Schema(description = "Their ids; null: all") @Nullable
            List<String> drones,

            @Schema(description = "Of each drone at most so many states a second, 1 to 50; left out: as before")
            @Nullable
            Integer rate)
            implements StreamRequest {}

    @Schema(name = "StreamPingRequest", description = "Asks for pong.")
    record Ping(@Nullable String requestId) implements StreamRequest {}
}
