package org.dronemap.ws.recording;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import jakarta.servlet.http.HttpServletRequest;
import java.io.IOException;
import java.net.URI;
import java.util.List;
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

/** REST handlers that upload a recording and play it back as replay drones, and list or stop replays. */
@RestController
@RequestMapping("/api/v1/replays")
@Tag(name = "Replays", description = "Recordings (tlog) played back: their drones are shown, marked, never commanded.")
class ReplayController {
    private final ReplayService replays;
    private final CurrentPrincipal current;

    /** All replays. */
    @Schema(name = "Replays")
    public record Replays(List<ReplayView> replays) {}

    ReplayController(ReplayService replays, CurrentPrincipal current) {
        this.replays = replays;
        this.current = current;
    }

    @PostMapping
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.ORGANISATION, costs = RequestCost.EXPORT)
    @ResponseStatuses(202)
    @FileMediaTypes(consumes = "application/octet-stream")
    @Operation(
            operationId = "startReplay",
            summary = "Play a recording (operator)",
            description = "The body is the tlog, up to 512 MB, as application/octet-stream.")
    public ResponseEntity<ReplayView> start(
            @Parameter(description = "1 to 100 times real time") @RequestParam(required = false) @Nullable Double speed,
            @RequestParam(required = false) @Nullable String name,
            @Parameter(hidden = true) HttpServletRequest request)
            throws IOException {
        ReplayView replay = replays.start(current.principal(), name, speed, request.getInputStream());
        return ResponseEntity.accepted()
                .location(URI.create("/api/v1/replays/" + replay.id()))
                .body(replay);
    }

    @GetMapping
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.ORGANISATION, costs = RequestCost.EXPORT)
    @Operation(operationId = "listReplays", summary = "List the replays")
    public Replays replays() {
        return new Replays(replays.replays(current.principal()));
    }

    @GetMapping("/{id}")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.ORGANISATION)
    @Operation(operationId = "getReplay", summary = "Look at one replay")
    public ReplayView replay(@PathVariable String id) {
        return replays.replay(current.principal(), id);
    }

    @DeleteMapping("/{id}")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.ORGANISATION)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(operationId = "removeReplay", summary = "End a replay and remove its drones (operator)")
    public void remove(@PathVariable String id) {
        replays.remove(current.principal(), id);
    }
}
