package org.dronemap.ws.parameter;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.tags.Tag;
import jakarta.servlet.http.HttpServletRequest;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import org.dronemap.core.parameter.ParameterFile;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.RequestCost;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.access.SoapName;
import org.dronemap.ws.command.CommandResponse;
import org.dronemap.ws.command.CommandService;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.http.FileMediaTypes;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.security.CurrentPrincipal;
import org.jspecify.annotations.Nullable;
import org.springframework.http.ContentDisposition;
import org.springframework.http.HttpHeaders;
import org.springframework.http.MediaType;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.PutMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.RestController;

/** REST handlers for the parameters on board of a vehicle, and for the parameter files of ground stations. */
@RestController
@RequestMapping("/api/v1/drones/{id}/parameters")
@Tag(name = "Parameters", description = "The settings of the vehicle itself; every change is read back.")
class ParameterController {
    private final ParameterService parameters;
    private final CommandService commands;
    private final CurrentPrincipal current;

    ParameterController(ParameterService parameters, CommandService commands, CurrentPrincipal current) {
        this.parameters = parameters;
        this.commands = commands;
        this.current = current;
    }

    @GetMapping
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE)
    @ResponseStatuses(never = 422)
    @Operation(
            operationId = "listParameters",
            summary = "List or search the parameters",
            description = "As last heard from the vehicle; readAt is null until they were first read.")
    public ParametersView parameters(
            @PathVariable String id,
            @Parameter(description = "Words that the name has in it") @RequestParam(required = false) @Nullable
                    String search) {
        return parameters.parameters(current.principal(), id, search);
    }

    @PostMapping("/refresh")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.DRONE)
    @ResponseStatuses({200, 202})
    @SoapName("refreshParameters")
    @Operation(
            operationId = "readParameters",
            summary = "Read all parameters from the vehicle (operator)",
            description = "Its progress is streamed.")
    public CompletableFuture<ResponseEntity<CommandView>> refresh(
            @PathVariable String id, @RequestParam(required = false) @Nullable Double wait) {
        Duration longest = CommandResponse.wait(wait);
        return CommandResponse.within(longest, commands, parameters.refresh(current.caller(), id));
    }

    @PutMapping("/{name}")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.DRONE)
    @ResponseStatuses({200, 202})
    @Operation(
            operationId = "setParameter",
            summary = "Change a parameter (operator)",
            description = "It is read back: when the vehicle holds something else, the command fails and says what.")
    public CompletableFuture<ResponseEntity<CommandView>> set(
            @PathVariable String id,
            @PathVariable String name,
            @RequestParam(required = false) @Nullable Double wait,
            @RequestBody ParameterService.ValueRequest request) {
        Duration longest = CommandResponse.wait(wait);
        return CommandResponse.within(longest, commands, parameters.set(current.caller(), id, name, request));
    }

    @GetMapping("/file")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE, costs = RequestCost.EXPORT)
    @ResponseStatuses(refuses = 409)
    @FileMediaTypes(produces = "text/plain")
    @Operation(
            operationId = "exportParameters",
            summary = "Save the parameters as a file",
            description = "form: list (the default; Mission Planner, MAVProxy) or table (QGroundControl).")
    public ResponseEntity<String> file(@PathVariable String id, @RequestParam(required = false) @Nullable String form) {
        String text = parameters.file(current.principal(), id, form);
        String name = id + ("table".equals(form) ? ".params" : ".param");
        return ResponseEntity.ok()
                .contentType(new MediaType(MediaType.TEXT_PLAIN, StandardCharsets.UTF_8))
                .header(
                        HttpHeaders.CONTENT_DISPOSITION,
                        ContentDisposition.attachment().filename(name).build().toString())
                .body(text);
    }

    @PostMapping("/file")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.DRONE, costs = RequestCost.EXPORT)
    @ResponseStatuses({200, 202})
    @FileMediaTypes(consumes = "text/plain")
    @Operation(
            operationId = "importParameters",
            summary = "Compare with a file, or load it (operator)",
            description = "The body is the file as text/plain, in either form, up to 1 MB. With dryRun=true nothing is"
                    + " sent; else what differs is changed and read back.")
    public ResponseEntity<ParametersView.FileView> load(
            @PathVariable String id,
            @RequestParam(defaultValue = "false") boolean dryRun,
            @Parameter(hidden = true) HttpServletRequest request)
            throws IOException {
        String text = ParameterFile.text(request.getInputStream().readAllBytes());
        ParametersView.FileView result =
                dryRun ? parameters.compare(current.caller(), id, text) : parameters.load(current.caller(), id, text);
        return ResponseEntity.status(result.command() == null ? 200 : 202).body(result);
    }
}
