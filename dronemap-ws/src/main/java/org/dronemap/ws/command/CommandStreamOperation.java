package org.dronemap.ws.command;

import com.fasterxml.jackson.annotation.JsonTypeName;
import io.swagger.v3.oas.annotations.media.Schema;
import org.dronemap.core.access.Principal;
import org.dronemap.ws.access.AuditNotes;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.stream.StreamAccessRule;
import org.dronemap.ws.stream.StreamMessage;
import org.dronemap.ws.stream.StreamOperation;
import org.dronemap.ws.stream.StreamRequest;
import org.dronemap.ws.stream.StreamRequestType;
import org.jspecify.annotations.Nullable;
import org.springframework.core.annotation.Order;

/** Gives commands that clients send on the WebSocket stream. Any thread. */
final class CommandStreamOperation {
    @JsonTypeName("command")
    @Schema(name = "StreamCommandRequest", description = "Gives a drone a command.")
    record GiveCommand(
            @Nullable String requestId,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED, description = "The id of a drone") @Nullable
            String drone,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED) @Nullable
            CommandRequest command)
            implements StreamRequest.OfUseCase {}

    @JsonTypeName("commandAccepted")
    @Order(710)
    @Schema(name = "StreamCommandAccepted", description = "Answers a command; its outcome follows.")
    record CommandAccepted(@Nullable String requestId, CommandView command) implements StreamMessage.OfUseCase {}

    private CommandStreamOperation() {}

    static StreamOperation<GiveCommand> of(CommandService commands) {
        return new StreamOperation<>(
                new StreamRequestType<>(
                        GiveCommand.class, new StreamAccessRule.OfOperation<>("giveCommand"), CommandAccepted.class),
                CommandStreamOperation::note,
                (connection, principal, request) -> submit(commands, principal, request));
    }

    private static void note(GiveCommand request) {
        CommandRequest command = request.command();
        if (command != null) {
            AuditNotes.sent(command);
        }
    }

    private static CommandAccepted submit(CommandService commands, Principal principal, GiveCommand request) {
        String drone = request.drone();
        CommandRequest command = request.command();
        if (drone == null) {
            throw InvalidInput.missing("drone", "the id of a drone");
        }
        if (command == null) {
            throw InvalidInput.missing("command", "an object such as {\"type\":\"arm\"}");
        }
        return new CommandAccepted(request.requestId(), commands.submit(principal, "stream", drone, command));
    }
}
