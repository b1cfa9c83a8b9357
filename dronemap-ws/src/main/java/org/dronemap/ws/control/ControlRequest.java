package org.dronemap.ws.control;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Size;
import java.util.function.Function;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.reading.NameRules;
import org.jspecify.annotations.Nullable;

/** Request about the control of a drone; one record for each action, with what goes with it. Nothing is checked yet. */
public sealed interface ControlRequest {
    int LONGEST_REASON = 200;

    ControlAction action();

    /**
     * Throws {@link InvalidInput} where a member cannot be used.
     *
     * @param by the name of who does it
     * @param pilot the name of that user, who may command the drone; throws for any other
     */
    LeaseEvent read(String by, Function<@Nullable String, String> pilot);

    /** Takes control where nobody has it. */
    record TakeControl() implements ControlRequest {
        @Override
        public ControlAction action() {
            return ControlAction.TAKE;
        }

        @Override
        public LeaseEvent read(String by, Function<@Nullable String, String> pilot) {
            return new LeaseEvent.TakeControl(by);
        }
    }

    /** Asks the holder for control. */
    @Schema(name = "ControlAskRequest", description = "Asks the holder for control.")
    record Ask(
            @Schema(description = "For the holder: at most 200 characters") @Size(max = LONGEST_REASON) @Nullable
            String reason)
            implements ControlRequest {
        @Override
        public ControlAction action() {
            return ControlAction.REQUEST;
        }

        @Override
        public LeaseEvent read(String by, Function<@Nullable String, String> pilot) {
            return new LeaseEvent.Request(by, ControlRequest.checked(reason));
        }
    }

    /** Gives control to somebody who asks for it. */
    @Schema(name = "ControlGrantRequest", description = "Gives control to somebody who asks for it.")
    record Grant(
            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "The name of the user") @Nullable
            String user)
            implements ControlRequest {
        @Override
        public ControlAction action() {
            return ControlAction.GRANT;
        }

        @Override
        public LeaseEvent read(String by, Function<@Nullable String, String> pilot) {
            return new LeaseEvent.Grant(by, pilot.apply(user));
        }
    }

    /** Keeps control from somebody who asks for it. */
    @Schema(name = "ControlRefuseRequest", description = "Keeps control from somebody who asks for it.")
    record Refuse(
            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "The name of the user") @Nullable
            String user,

            @Schema(description = "For that user: at most 200 characters") @Size(max = LONGEST_REASON) @Nullable
            String reason)
            implements ControlRequest {
        @Override
        public ControlAction action() {
            return ControlAction.REFUSE;
        }

        @Override
        public LeaseEvent read(String by, Function<@Nullable String, String> pilot) {
            return new LeaseEvent.Refuse(by, ControlRequest.named(user), ControlRequest.checked(reason));
        }
    }

    /** Gives control to somebody, asked or not. */
    @Schema(name = "ControlHandOverRequest", description = "Gives control to somebody.")
    record HandOver(
            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "The name of the user") @Nullable
            String user)
            implements ControlRequest {
        @Override
        public ControlAction action() {
            return ControlAction.HAND_OVER;
        }

        @Override
        public LeaseEvent read(String by, Function<@Nullable String, String> pilot) {
            return new LeaseEvent.HandOver(by, pilot.apply(user));
        }
    }

    /** Takes control from whoever has it. */
    @Schema(name = "ControlTakeOverRequest", description = "Takes control from whoever has it.")
    record TakeOver(
            @Schema(
                    requiredMode = Schema.RequiredMode.REQUIRED,
                    description = "For all who see the drone: 1 to 200 characters")
            @Size(min = 1, max = LONGEST_REASON)
            @Nullable
            String reason)
            implements ControlRequest {
        @Override
        public ControlAction action() {
            return ControlAction.TAKE_OVER;
        }

        @Override
        public LeaseEvent read(String by, Function<@Nullable String, String> pilot) {
            return new LeaseEvent.TakeOver(by, NameRules.checked("reason", reason, LONGEST_REASON));
        }
    }

    /** The holder is there. */
    @Schema(name = "ControlHeartbeatRequest", description = "The holder is there.")
    record Heartbeat(
            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "Of the control that was taken")
            @Nullable
            Long epoch)
            implements ControlRequest {
        @Override
        public ControlAction action() {
            return ControlAction.HEARTBEAT;
        }

        @Override
        public LeaseEvent read(String by, Function<@Nullable String, String> pilot) {
            if (epoch == null) {
                throw InvalidInput.missing("epoch", "the one that taking control was answered with");
            }
            return new LeaseEvent.Heartbeat(by, epoch);
        }
    }

    /** Gives control back. */
    record Release() implements ControlRequest {
        @Override
        public ControlAction action() {
            return ControlAction.RELEASE;
        }

        @Override
        public LeaseEvent read(String by, Function<@Nullable String, String> pilot) {
            return new LeaseEvent.Release(by);
        }
    }

    private static @Nullable String checked(@Nullable String reason) {
        return reason == null || reason.isBlank() ? null : NameRules.checked("reason", reason, LONGEST_REASON);
    }

    /** Without spaces around it; throws {@link InvalidInput} where there is none. */
    static String named(@Nullable String user) {
        if (user == null || user.isBlank()) {
            throw InvalidInput.missing("user", "the name of a user");
        }
        return user.strip();
    }
}
