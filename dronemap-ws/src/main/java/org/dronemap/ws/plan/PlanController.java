package org.dronemap.ws.plan;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.net.URI;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.command.CommandResponse;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.security.CurrentPrincipal;
import org.jspecify.annotations.Nullable;
import org.springframework.http.HttpStatus;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.DeleteMapping;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;

/** REST handlers that request, show and accept plans: missions for several drones that are computed together. */
@RestController
@RequestMapping("/api/v1/plans")
@Tag(
        name = "Plans",
        description =
                "Waypoints shared out among several drones: searched for in the background, round the zones of the"
                        + " cloud, within batteries and time windows, with the drones kept apart; checked by an independent"
                        + " checker; uploaded and started when you accept.")
class PlanController {
    private final PlanService plans;
    private final CurrentPrincipal current;

    /** Plans, the oldest first. */
    @Schema(name = "PlanList")
    public record PlanList(List<PlanView> plans) {}

    PlanController(PlanService plans, CurrentPrincipal current) {
        this.plans = plans;
        this.current = current;
    }

    @GetMapping
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.SHARED)
    @Operation(
            operationId = "listPlans",
            summary = "List your plans",
            description = "Without their ways. Forgotten an hour after they ended.")
    public PlanList all() {
        return new PlanList(plans.all(current.principal()));
    }

    @GetMapping("/{id}")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.SHARED)
    @Operation(
            operationId = "getPlan",
            summary = "Look at one plan",
            description = "How far the search is, and once it is finished who flies where and when.")
    public PlanView one(@PathVariable String id) {
        return plans.one(current.principal(), id);
    }

    @PostMapping
    @Access(from = AccessLevel.PLANNER, about = ResourceScope.SHARED)
    @ResponseStatuses(value = 202, refuses = 404)
    @Operation(
            operationId = "makePlan",
            summary = "Ask for a plan (planner)",
            description = "Answered at once; look at it until it is finished, or hear of it on the stream. Where drones"
                    + " are, their homes, batteries, links and kinds are those that the cloud knows now: whatever is not"
                    + " known is said. 503 when too many wait already.")
    public ResponseEntity<PlanView> ask(@RequestBody PlanRequest request) {
        PlanView asked = plans.ask(current.principal(), request);
        return ResponseEntity.accepted()
                .location(URI.create("/api/v1/plans/" + asked.id()))
                .body(asked);
    }

    @DeleteMapping("/{id}")
    @Access(from = AccessLevel.PLANNER, about = ResourceScope.SHARED)
    @ResponseStatuses(refuses = 409)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(
            operationId = "removePlan",
            summary = "Cancel or forget a plan (planner)",
            description = "Cancels one that is queued or running; forgets one that has ended.")
    public void remove(@PathVariable String id) {
        plans.remove(current.principal(), id);
    }

    @PostMapping("/{id}/accept")
    @Access(from = AccessLevel.PLANNER, about = ResourceScope.SHARED)
    @ResponseStatuses({200, 202})
    @Operation(
            operationId = "acceptPlan",
            summary = "Accept a plan (planner; to start it operator)",
            description =
                    "Uploads each drone's mission: one outcome for each drone. With start the drones are armed and"
                            + " started, each when the plan says, once all have their missions. 200 when nothing is under way"
                            + " any more, else 202. 409 when the plan must not be flown, or a drone has moved.")
    public CompletableFuture<ResponseEntity<PlanView>> accept(
            @PathVariable String id,
            @Parameter(description = "Seconds to wait for the outcomes, 0 to 60")
                    @RequestParam(required = false)
                    @Nullable
                    Double wait,
            @RequestBody(required = false) PlanRequest.@Nullable AcceptRequest request) {
        Duration longest = CommandResponse.wait(wait);
        return plans.accept(current.caller(), id, request, longest).thenApply(PlanController::answer);
    }

    @PostMapping("/{id}/stop")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @Operation(
            operationId = "stopPlan",
            summary = "Stop the start of a plan (operator)",
            description =
                    "Drones that have not been started yet are not started, and disarmed where they were armed for"
                            + " it. Drones that fly, fly on: call them back by their own commands. 409 when nothing is under"
                            + " way.")
    public PlanView stop(@PathVariable String id) {
        return plans.stop(current.principal(), id);
    }

    private static ResponseEntity<PlanView> answer(PlanView plan) {
        return ResponseEntity.status(plan.isLaunched() ? HttpStatus.OK : HttpStatus.ACCEPTED)
                .body(plan);
    }
}
