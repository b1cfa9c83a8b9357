package org.dronemap.ws.log;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.nio.file.Path;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.RequestCost;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.access.SoapName;
import org.dronemap.ws.command.CommandResponse;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.http.FileMediaTypes;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.security.CurrentPrincipal;
import org.springframework.core.io.FileSystemResource;
import org.springframework.core.io.Resource;
import org.springframework.http.ContentDisposition;
import org.springframework.http.HttpHeaders;
import org.springframework.http.HttpStatus;
import org.springframework.http.MediaType;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.DeleteMapping;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;

/** REST handlers that list the logs on board of a vehicle, download them to the server and hand them out. */
@RestController
@RequestMapping("/api/v1/drones/{id}/logs")
@Tag(name = "Logs", description = "What the vehicle wrote on board, fetched over its link.")
class OnboardLogController {
    private final OnboardLogService logs;
    private final CurrentPrincipal current;

    OnboardLogController(OnboardLogService logs, CurrentPrincipal current) {
        this.logs = logs;
        this.current = current;
    }

    @GetMapping
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE)
    @Operation(
            operationId = "listLogs",
            summary = "List the logs on board",
            description = "As last listed; null until they first were.")
    public OnboardLogsView logs(@PathVariable String id) {
        return logs.logs(current.principal(), id);
    }

    @PostMapping("/refresh")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.DRONE)
    @ResponseStatuses(202)
    @SoapName("refreshLogs")
    @Operation(operationId = "readLogs", summary = "Ask the vehicle for the list of its logs (operator)")
    public ResponseEntity<CommandView> refresh(@PathVariable String id) {
        return CommandResponse.begun(logs.refresh(current.caller(), id));
    }

    @PostMapping("/{number}/download")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.DRONE)
    @ResponseStatuses(202)
    @Operation(
            operationId = "downloadLog",
            summary = "Fetch a log from the vehicle (operator)",
            description =
                    "The command's progress counts bytes and is streamed; a later attempt goes on where one ended.")
    public ResponseEntity<CommandView> download(@PathVariable String id, @PathVariable int number) {
        return CommandResponse.begun(logs.download(current.caller(), id, number));
    }

    @GetMapping("/{number}/file")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE, costs = RequestCost.EXPORT)
    @ResponseStatuses(refuses = 409)
    @FileMediaTypes(produces = "application/octet-stream")
    @Operation(operationId = "getLogFile", summary = "Save a log that was fetched")
    public ResponseEntity<Resource> file(@PathVariable String id, @PathVariable int number) {
        Path file = logs.file(current.principal(), id, number);
        return ResponseEntity.ok()
                .contentType(MediaType.APPLICATION_OCTET_STREAM)
                .header(
                        HttpHeaders.CONTENT_DISPOSITION,
                        ContentDisposition.attachment()
                                .filename(id + "-" + number + ".bin")
                                .build()
                                .toString())
                .body(new FileSystemResource(file));
    }

    @DeleteMapping("/{number}/file")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.DRONE, costs = RequestCost.EXPORT)
    @ResponseStatuses(refuses = 409)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(operationId = "deleteLogFile", summary = "Remove the server's copy of a log (operator)")
    public void remove(@PathVariable String id, @PathVariable int number) {
        logs.remove(current.caller(), id, number);
    }
}
