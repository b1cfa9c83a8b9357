package org.dronemap.ws.control;

import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Size;
import org.dronemap.ws.reading.ObjectOnlyTypeResolver;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.annotation.JsonTypeResolver;

/** Request on the WebSocket stream about the control of a drone; one record for each action. */
@JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "action")
@JsonTypeResolver(ObjectOnlyTypeResolver.class)
@JsonSubTypes({
    @JsonSubTypes.Type(value = StreamControlRequest.TakeControl.class, name = "take"),
    @JsonSubTypes.Type(value = StreamControlRequest.Ask.class, name = "request"),
    @JsonSubTypes.Type(value = StreamControlRequest.Grant.class, name = "grant"),
    @JsonSubTypes.Type(value = StreamControlRequest.Refuse.class, name = "refuse"),
    @JsonSubTypes.Type(value = StreamControlRequest.HandOver.class, name = "handOver"),
    @JsonSubTypes.Type(value = StreamControlRequest.TakeOver.class, name = "takeOver"),
    @JsonSubTypes.Type(value = StreamControlRequest.Heartbeat.class, name = "heartbeat"),
    @JsonSubTypes.Type(value = StreamControlRequest.Release.class, name = "release")
})
@Schema(
        name = "StreamControlRequest",
        description = "Does something about who has control of a drone; which members there are depends on the action.")
sealed interface StreamControlRequest extends ControlStreamOperation.ControlRequestType {
    /** What REST would be asked for. */
    ControlRequest asked();

    /** Whom it is granted, refused or handed over to. */
    default @Nullable String user() {
        return null;
    }

    /** For people. */
    default @Nullable String reason() {
        return null;
    }

    @Schema(name = "StreamControlTakeRequest", description = "Takes control where nobody has it.")
    record TakeControl(
            @Nullable String requestId,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "The id of a drone") @Nullable
            String drone)
            implements StreamControlRequest {
        @Override
        public ControlRequest asked() {
            return new ControlRequest.TakeControl();
        }
    }

    @Schema(name = "StreamControlAskRequest", description = "Asks the holder for control.")
    record Ask(
            @Nullable String requestId,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "The id of a drone") @Nullable
            String drone,

            @Schema(description = "For the holder: at most 200 characters")
            @Size(max = ControlRequest.LONGEST_REASON)
            @Nullable
            String reason)
            implements StreamControlRequest {
        @Override
        public ControlRequest asked() {
            return new ControlRequest.Ask(reason);
        }
    }

    @Schema(name = "StreamControlGrantRequest", description = "Gives control to somebody who asks for it.")
    record Grant(
            @Nullable String requestId,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "The id of a drone") @Nullable
            String drone,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "The name of the user") @Nullable
            String user)
            implements StreamControlRequest {
        @Override
        public ControlRequest asked() {
            return new ControlRequest.Grant(user);
        }
    }

    @Schema(name = "StreamControlRefuseRequest", description = "Keeps control from somebody who asks for it.")
    record Refuse(
            @Nullable String requestId,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "The id of a drone") @Nullable
            String drone,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "The name of the user") @Nullable
            String user,

            @Schema(description = "For that user: at most 200 characters")
            @Size(max = ControlRequest.LONGEST_REASON)
            @Nullable
            String reason)
            implements StreamControlRequest {
        @Override
        public ControlRequest asked() {
            return new ControlRequest.Refuse(user, reason);
        }
    }

    @Schema(name = "StreamControlHandOverRequest", description = "Gives control to somebody.")
    record HandOver(
            @Nullable String requestId,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "The id of a drone") @Nullable
            String drone,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "The name of the user") @Nullable
            String user)
            implements StreamControlRequest {
        @Override
        public ControlRequest asked() {
            return new ControlRequest.HandOver(user);
        }
    }

    @Schema(name = "StreamControlTakeOverRequest", description = "Takes control from whoever has it.")
    record TakeOver(
            @Nullable String requestId,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "The id of a drone") @Nullable
            String drone,

            @Schema(
                    requiredMode = Schema.RequiredMode.REQUIRED,
                    description = "For all who see the drone: 1 to 200 characters")
            @Size(min = 1, max = ControlRequest.LONGEST_REASON)
            @Nullable
            String reason)
            implements StreamControlRequest {
        @Override
        public ControlRequest asked() {
            return new ControlRequest.TakeOver(reason);
        }
    }

    @Schema(name = "StreamControlHeartbeatRequest", description = "The holder is there.")
    record Heartbeat(
            @Nullable String requestId,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "The id of a drone") @Nullable
            String drone,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Of the control that was taken")
            @Nullable
            Long epoch)
            implements StreamControlRequest {
        @Override
        public ControlRequest asked() {
            return new ControlRequest.Heartbeat(epoch);
        }
    }

    @Schema(name = "StreamControlReleaseRequest", description = "Gives control back.")
    record Release(
            @Nullable String requestId,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "The id of a drone") @Nullable
            String drone)
            implements StreamControlRequest {
        @Override
        public ControlRequest asked() {
            return new ControlRequest.Release();
        }
    }
}
