package org.dronemap.ws.command;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.RequestCost;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.access.SoapName;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.security.CurrentPrincipal;
import org.jspecify.annotations.Nullable;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.RestController;

/** REST handlers that give a command to a drone, and list commands with their outcomes. */
@RestController
@RequestMapping("/api/v1")
@Tag(name = "Commands", description = "Each command ends in exactly one outcome; the same id twice acts once.")
class CommandController {
    private final CommandService commands;
    private final CurrentPrincipal current;

    /** Commands, newest first. */
    @Schema(name = "Commands")
    public record Commands(List<CommandView> commands) {}

    CommandController(CommandService commands, CurrentPrincipal current) {
        this.commands = commands;
        this.current = current;
    }

    @PostMapping("/drones/{id}/commands")
    @Access(from = AccessLevel.PLANNER, about = ResourceScope.DRONE, costs = RequestCost.NOTHING)
    @ResponseStatuses({200, 202})
    @SoapName(alternatives = {"takeOff=takeoff", "goTo=goto"})
    @Operation(
            operationId = "giveCommand",
            summary = "Give a command (operator)",
            description = "202 with the command under way; with wait: 200 with its outcome if it ends in that time."
                    + " 409 when the drone's state does not allow it, with the sentence why.")
    public CompletableFuture<ResponseEntity<CommandView>> submit(
            @PathVariable String id,
            @Parameter(description = "Seconds to wait for the outcome, 0 to 60")
                    @RequestParam(required = false)
                    @Nullable
                    Double wait,
            @RequestBody CommandRequest request) {
        Duration longest = CommandResponse.wait(wait);
        CommandView command = commands.submit(current.principal(), current.face(), id, request);
        return CommandResponse.within(longest, commands, command);
    }

    @GetMapping("/drones/{id}/commands")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE)
    @Operation(
            operationId = "listCommands",
            summary = "List a drone's last commands",
            description = "Newest first, at most 50.")
    public Commands commandsOf(@PathVariable String id) {
        return new Commands(commands.commandsOf(current.principal(), id));
    }

    @GetMapping("/commands/{id}")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE)
    @Operation(operationId = "getCommand", summary = "Look at one command")
    public CommandView command(@PathVariable String id) {
        return commands.command(current.principal(), id);
    }
}
