package org.dronemap.ws.stream;

import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.List;
import org.dronemap.ws.command.CommandRequest;
import org.dronemap.ws.control.SteeringRequest;
import org.dronemap.ws.follow.FollowRequest;
import org.dronemap.ws.reading.ObjectOnlyTypeResolver;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.annotation.JsonTypeResolver;

/** A request that a client sends on the WebSocket stream. Nothing is checked yet. */
@JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "type")
@JsonTypeResolver(ObjectOnlyTypeResolver.class)
@JsonSubTypes({
    @JsonSubTypes.Type(value = StreamRequest.Authenticate.class, name = "authenticate"),
    @JsonSubTypes.Type(value = StreamRequest.GiveCommand.class, name = "command"),
    @JsonSubTypes.Type(value = StreamControlRequest.class, name = "control"),
    @JsonSubTypes.Type(value = StreamRequest.Steer.class, name = "steer"),
    @JsonSubTypes.Type(value = StreamRequest.LetGo.class, name = "letGo"),
    @JsonSubTypes.Type(value = StreamRequest.Positions.class, name = "positions"),
    @JsonSubTypes.Type(value = StreamRequest.Subscribe.class, name = "subscribe"),
    @JsonSubTypes.Type(value = StreamRequest.Ping.class, name = "ping")
})
@Schema(name = "StreamRequest", description = "What a client says; which members there are depends on the type.")
public sealed interface StreamRequest
        permits StreamRequest.Authenticate,
                StreamRequest.GiveCommand,
                StreamControlRequest,
                StreamRequest.Steer,
                StreamRequest.LetGo,
                StreamRequest.Positions,
                StreamRequest.Subscribe,
                StreamRequest.Ping {
    StreamRequestKind kind();

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
            implements StreamRequest {
        @Override
        public StreamRequestKind kind() {
            return StreamRequestKind.AUTHENTICATE;
        }
    }

    @Schema(name = "StreamCommandRequest", description = "Gives a drone a command.")
    record GiveCommand(
            @Nullable String requestId,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "The id of a drone") @Nullable
            String drone,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED) @Nullable
            CommandRequest command)
            implements StreamRequest {
        @Override
        public StreamRequestKind kind() {
            return StreamRequestKind.COMMAND;
        }
    }

    @Schema(name = "StreamSteerRequest", description = "Steers for half a second, by speeds or by sticks.")
    record Steer(
            @Nullable String requestId,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "The id of a drone") @Nullable
            String drone,

            SteeringRequest.@Nullable Velocity velocity,
            SteeringRequest.@Nullable Sticks sticks,

            @Schema(description = "It counts under that control only") @Nullable
            Long epoch)
            implements StreamRequest {
        @Override
        public StreamRequestKind kind() {
            return StreamRequestKind.STEER;
        }
    }

    @Schema(name = "StreamLetGoRequest", description = "Ends what was steered: the vehicle stands still at once.")
    record LetGo(
            @Nullable String requestId,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "The id of a drone") @Nullable
            String drone)
            implements StreamRequest {
        @Override
        public StreamRequestKind kind() {
            return StreamRequestKind.LET_GO;
        }
    }

    @Schema(
            name = "StreamPositionsRequest",
            description = "Where a followed phone was, oldest first, once a second. Times are by its own clock.")
    record Positions(
            @Nullable String requestId,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "The id of a follow") @Nullable
            String follow,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "When this is sent") @Nullable
            Instant sent,

            @Schema(description = "Milliseconds from sending one to its answer, as measured lately") @Nullable
            Double roundTrip,

            @Schema(
                    requiredMode = Schema.RequiredMode.REQUIRED,
                    description = "Up to 60. None: the phone is there, and does not know where it is")
            @Nullable
            List<FollowRequest.@Nullable PositionRequest> positions)
            implements StreamRequest {
        @Override
        public StreamRequestKind kind() {
            return StreamRequestKind.POSITIONS;
        }
    }

    @Schema(name = "StreamSubscribeRequest", description = "Says which drones shall be told of, and how often.")
    record Subscribe(
            @Nullable String requestId,

            @Schema(description = "Their ids; null: all") @Nullable
            List<String> drones,

            @Schema(description = "Of each drone at most so many states a second, 1 to 50; left out: as before")
            @Nullable
            Integer rate)
            implements StreamRequest {
        @Override
        public StreamRequestKind kind() {
            return StreamRequestKind.SUBSCRIBE;
        }
    }

    @Schema(name = "StreamPingRequest", description = "Asks for pong.")
    record Ping(@Nullable String requestId) implements StreamRequest {
        @Override
        public StreamRequestKind kind() {
            return StreamRequestKind.PING;
        }
    }
}
