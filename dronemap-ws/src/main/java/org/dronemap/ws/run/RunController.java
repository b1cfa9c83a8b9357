package org.dronemap.ws.run;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.net.URI;
import java.util.List;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.security.CurrentPrincipal;
import org.dronemap.ws.zone.ZoneFeature;
import org.jspecify.annotations.Nullable;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.DeleteMapping;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PatchMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.RestController;

/** REST handlers for mission runs: plans that several drones fly, and that are re-planned while they fly. */
@RestController
@RequestMapping("/api/v1/runs")
@Tag(
        name = "Mission runs",
        description =
                "Plans that the cloud has drones fly: it watches them, shares out anew what a lost drone leaves, takes new"
                        + " and moved waypoints, and explains each decision. A run survives its user's departure and restarts"
                        + " of the server.")
class RunController {
    private final RunService runs;
    private final RunJournalService journals;
    private final CurrentPrincipal current;

    /** Mission runs, the newest first. */
    @Schema(name = "RunList")
    public record RunList(List<RunView> runs) {}

    RunController(RunService runs, RunJournalService journals, CurrentPrincipal current) {
        this.runs = runs;
        this.journals = journals;
        this.current = current;
    }

    @GetMapping
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.SHARED)
    @Operation(
            operationId = "listRuns",
            summary = "List mission runs",
            description = "Those of your organisation all of whose drones you see: under way, and the newest that are"
                    + " over. Forgotten 90 days after their end.")
    public RunList all() {
        return new RunList(runs.all(current.principal()));
    }

    @GetMapping("/{id}")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.SHARED)
    @Operation(
            operationId = "getRun",
            summary = "Look at one mission run",
            description = "How it stands with each waypoint and drone, and what was decided why.")
    public RunView one(@PathVariable String id) {
        return runs.one(current.principal(), id);
    }

    @PostMapping
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @ResponseStatuses(value = 201, refuses = 404)
    @Operation(
            operationId = "startRun",
            summary = "Fly a plan (operator)",
            description =
                    "Takes control of the plan's drones, brings them their missions, starts them and conducts them to the"
                            + " end. 409 when the plan must not be flown, or somebody has control of one of its drones.")
    public ResponseEntity<RunView> start(@RequestBody RunRequest.StartRequest request) {
        RunView started = runs.start(current.principal(), request);
        return ResponseEntity.created(URI.create("/api/v1/runs/" + started.id()))
                .body(started);
    }

    @PostMapping("/{id}/waypoints")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @Operation(
            operationId = "addRunWaypoints",
            summary = "Add waypoints to a mission run (operator)",
            description = "Shared out among the drones that fly.")
    public RunView add(@PathVariable String id, @RequestBody RunRequest.WaypointsRequest request) {
        return runs.add(current.principal(), id, request);
    }

    @PatchMapping("/{id}/waypoints/{waypoint}")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @Operation(
            operationId = "moveRunWaypoint",
            summary = "Move a waypoint of a mission run (operator)",
            description = "What is left out of latitude, longitude and altitude stays; one of them is needed.")
    public RunView move(
            @PathVariable String id, @PathVariable String waypoint, @RequestBody RunRequest.MoveRequest request) {
        return runs.move(current.principal(), id, waypoint, request);
    }

    @DeleteMapping("/{id}/waypoints/{waypoint}")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @ResponseStatuses(refuses = 409)
    @Operation(operationId = "cancelRunWaypoint", summary = "Cancel a waypoint of a mission run (operator)")
    public RunView cancel(@PathVariable String id, @PathVariable String waypoint) {
        return runs.cancel(current.principal(), id, waypoint);
    }

    @PostMapping("/{id}/barriers")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @Operation(
            operationId = "addRunBarrier",
            summary = "Add a zone to a mission run (operator)",
            description =
                    "A GeoJSON feature as of a zone of the cloud; binds all drones of the run at once, until it is over.")
    public RunView bar(@PathVariable String id, @RequestBody ZoneFeature feature) {
        return runs.bar(current.principal(), id, feature);
    }

    @PostMapping("/{id}/drones")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @Operation(
            operationId = "joinRun",
            summary = "Have a further drone join a mission run (operator)",
            description = "One that stands on the ground and that nobody else has control of.")
    public RunView join(@PathVariable String id, @RequestBody RunRequest.JoinRequest request) {
        return runs.join(current.principal(), id, request);
    }

    @PostMapping("/{id}/drones/{drone}/resume")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @Operation(
            operationId = "resumeRunDrone",
            summary = "Give a drone back to its mission run (operator)",
            description = "One that a pilot or somebody else took. Nothing else gives control back to the run.")
    public RunView resume(@PathVariable String id, @PathVariable String drone) {
        return runs.resume(current.principal(), id, drone);
    }

    @PostMapping("/{id}/drones/{drone}/give-up")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @Operation(
            operationId = "giveUpRunDrone",
            summary = "Take a drone out of a mission run (operator)",
            description = "It is called home, and others fly its waypoints.")
    public RunView giveUp(@PathVariable String id, @PathVariable String drone) {
        return runs.giveUp(current.principal(), id, drone);
    }

    @PostMapping("/{id}/answers/{proposal}")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @Operation(
            operationId = "answerRun",
            summary = "Answer a proposal of a mission run (operator)",
            description = "By its number. 409 when another one waits by now, or none.")
    public RunView answer(
            @PathVariable String id, @PathVariable String proposal, @RequestBody RunRequest.AnswerRequest request) {
        return runs.answer(current.principal(), id, proposal, request);
    }

    @PostMapping("/{id}/pause")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @Operation(
            operationId = "pauseRun",
            summary = "Pause a mission run (operator)",
            description = "Its drones in the air hold where they are, those on the ground stay there; who is on its way"
                    + " home, or has nothing left to visit, comes down. 409 when it is paused already.")
    public RunView pause(@PathVariable String id) {
        return runs.pause(current.principal(), id);
    }

    @PostMapping("/{id}/continue")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @Operation(
            operationId = "continueRun",
            summary = "Let a paused mission run go on (operator)",
            description = "All go on where they stopped. 409 when it is not paused.")
    public RunView goOn(@PathVariable String id) {
        return runs.goOn(current.principal(), id);
    }

    @PostMapping("/{id}/stop")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @Operation(
            operationId = "stopRun",
            summary = "Stop a mission run (operator)",
            description = "Its drones return; it is over when all are down.")
    public RunView stop(@PathVariable String id) {
        return runs.stop(current.principal(), id);
    }

    @GetMapping("/{id}/journal")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @Operation(
            operationId = "getRunJournal",
            summary = "Read the journal of a mission run (operator)",
            description = "All that befell it and what it decided, up to 200 entries at once.")
    public RunJournalService.JournalView journal(
            @PathVariable String id,
            @Parameter(description = "The number of the first entry; left out: 0")
                    @RequestParam(required = false)
                    @Nullable
                    Long from) {
        return journals.journal(current.principal(), id, from == null ? 0 : from);
    }

    @GetMapping("/{id}/journal/replay")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @Operation(
            operationId = "replayRunJournal",
            summary = "Replay the journal of a mission run (operator)",
            description =
                    "Decides once more on all that befell it, and tells the first decision that differs by a letter.")
    public RunJournalService.JournalReplayView replay(@PathVariable String id) {
        return journals.replay(current.principal(), id);
    }
}
