package org.dronemap.ws.recording;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.tags.Tag;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.nio.file.Files;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.RequestCost;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.http.FileMediaTypes;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.security.CurrentPrincipal;
import org.jspecify.annotations.Nullable;
import org.springframework.http.HttpStatus;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.DeleteMapping;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;

/** REST handlers that list, download, replay and delete recordings of flights. */
@RestController
@RequestMapping("/api/v1/recordings")
@Tag(name = "Recordings", description = "Each flight or drive: all that a vehicle said and was told.")
class RecordingController {
    private final RecordingService recordings;
    private final CurrentPrincipal current;

    RecordingController(RecordingService recordings, CurrentPrincipal current) {
        this.recordings = recordings;
        this.current = current;
    }

    @GetMapping
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE)
    @ResponseStatuses(never = 422)
    @Operation(
            operationId = "listRecordings",
            summary = "List the recordings, newest first, and the room that they take")
    public RecordingView.Page recordings(
            @Parameter(description = "only those of this drone") @RequestParam(required = false) @Nullable
                    String drone) {
        return recordings.recordings(current.principal(), drone);
    }

    @GetMapping("/{id}")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE)
    @Operation(operationId = "getRecording", summary = "Look at one recording")
    public RecordingView recording(@PathVariable String id) {
        return recordings.recording(current.principal(), id);
    }

    @GetMapping("/{id}/file")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE, costs = RequestCost.EXPORT)
    @ResponseStatuses(refuses = 409)
    @FileMediaTypes(produces = {"application/octet-stream", "application/jsonl"})
    @Operation(
            operationId = "getRecordingFile",
            summary = "Download a recording",
            description = "While the flight goes on: all that was heard so far. A tlog, which"
                    + " other programs read, or of robots a line of JSON for each message (.jsonl).")
    public void file(@PathVariable String id, @Parameter(hidden = true) HttpServletResponse response)
            throws IOException {
        RecordingService.Download file = recordings.download(current.principal(), id);
        boolean lines = file.name().endsWith(RecordingService.LINES);
        send(file, lines ? "application/jsonl" : "application/octet-stream", response);
    }

    @GetMapping("/{id}/sent")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE)
    @ResponseStatuses(refuses = 409)
    @FileMediaTypes(produces = "text/tab-separated-values")
    @Operation(
            operationId = "getRecordingSent",
            summary = "Download who sent what in a recording (tab-separated)",
            description = "A line for each frame that went to the vehicle: its place in the file of the recording"
                    + " (bytes), the command that it was sent for, the epoch of control, and the user.")
    public void sent(@PathVariable String id, @Parameter(hidden = true) HttpServletResponse response)
            throws IOException {
        send(recordings.sent(current.principal(), id), "text/tab-separated-values;charset=UTF-8", response);
    }

    private static void send(RecordingService.Download download, String type, HttpServletResponse response)
            throws IOException {
        try (InputStream in = Files.newInputStream(download.file())) {
            // The length of now: a flight that goes on makes the file longer while it is sent.
            long length = Files.size(download.file());
            response.setContentType(type);
            response.setHeader("Content-Disposition", "attachment; filename=\"" + download.name() + "\"");
            response.setContentLengthLong(length);
            copy(in, response, length);
        }
    }

    private static void copy(InputStream in, HttpServletResponse response, long length) throws IOException {
        byte[] buffer = new byte[65_536];
        long left = length;
        while (left > 0) {
            int count = in.read(buffer, 0, (int) Math.min(buffer.length, left));
            if (count < 0) {
                throw new IOException("the recording became shorter while it was sent");
            }
            response.getOutputStream().write(buffer, 0, count);
            left -= count;
        }
    }

    @PostMapping("/{id}/replays")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.ORGANISATION, costs = RequestCost.EXPORT)
    @ResponseStatuses(202)
    @Operation(operationId = "replayRecording", summary = "Play a recording on the map (operator)")
    public ResponseEntity<ReplayView> replay(
            @PathVariable String id,
            @Parameter(description = "1 to 100 times real time") @RequestParam(required = false) @Nullable Double speed)
            throws IOException {
        ReplayView replay = recordings.replay(current.principal(), id, speed);
        return ResponseEntity.accepted()
                .location(URI.create("/api/v1/replays/" + replay.id()))
                .body(replay);
    }

    @DeleteMapping("/{id}")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.DRONE)
    @ResponseStatuses(refuses = 409)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(operationId = "deleteRecording", summary = "Delete a recording for ever (operator)")
    public void delete(
            @PathVariable String id,
            @Parameter(description = "must be true") @RequestParam(required = false) @Nullable Boolean confirm)
            throws IOException {
        recordings.delete(current.principal(), id, Boolean.TRUE.equals(confirm));
    }
}
