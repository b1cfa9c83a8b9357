package org.dronemap.ws.follow;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.net.URI;
import java.util.List;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.AuditPolicy;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.access.SoapName;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.security.CurrentPrincipal;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PatchMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RestController;

/**
 * REST handlers by which a phone asks to be followed by a drone, reports its position, and changes or ends the follow.
 */
@RestController
@RequestMapping("/api/v1/follows")
@Tag(
        name = "Follows",
        description =
                "A phone asks to be followed: a drone is chosen and kept for it, takes off when it is started, and stays beside"
                        + " the phone as long as that says where it is. It holds 2 s after the last position, and flies home"
                        + " when none come any more, or the battery asks for it.")
class FollowController {
    private final FollowService follows;
    private final CurrentPrincipal current;

    /** Follows, the newest first. */
    @Schema(name = "FollowList")
    public record FollowList(List<FollowView> follows) {}

    FollowController(FollowService follows, CurrentPrincipal current) {
        this.follows = follows;
        this.current = current;
    }

    @GetMapping
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.SHARED)
    @SoapName("getFollowsList")
    @Operation(
            operationId = "listFollows",
            summary = "List follows",
            description = "Those of your organisation whose drones you see: under way, and the newest that are over.")
    public FollowList all() {
        return new FollowList(follows.all(current.principal()));
    }

    @GetMapping("/{id}")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.SHARED)
    @Operation(operationId = "getFollow", summary = "Look at one follow")
    public FollowView one(@PathVariable String id) {
        return follows.one(current.principal(), id);
    }

    @PostMapping
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @ResponseStatuses(value = 201, refuses = 404)
    @SoapName("followRequest")
    @Operation(
            operationId = "openFollow",
            summary = "Ask to be followed (operator)",
            description =
                    "Chooses the drone of the warehouse that is nearest and has enough in its battery, or takes the one that is"
                            + " named, and keeps it. 409 with why each cannot, when none can.")
    public ResponseEntity<FollowView> open(@RequestBody FollowRequest.OpenRequest request) {
        FollowView opened = follows.open(current.principal(), request);
        return ResponseEntity.created(URI.create("/api/v1/follows/" + opened.id()))
                .body(opened);
    }

    @PatchMapping("/{id}")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @Operation(operationId = "changeFollow", summary = "Change where the drone stays (operator)")
    public FollowView change(@PathVariable String id, @RequestBody FollowRequest.PlaceRequest request) {
        return follows.change(current.principal(), id, request);
    }

    @PostMapping("/{id}/positions")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED, audit = AuditPolicy.REFUSALS_ONLY)
    @SoapName("sendNewGPSLocation")
    @Operation(
            operationId = "reportFollowPositions",
            summary = "Say where the phone is (operator)",
            description =
                    "Once a second or so. What was said before may be said again: it counts once. Only the user who asked"
                            + " to be followed says that. 409 when the follow is over.")
    public FollowReceipt positions(@PathVariable String id, @RequestBody FollowRequest.PositionsRequest request) {
        return follows.positions(current.principal(), id, request);
    }

    @PostMapping("/{id}/start")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @SoapName("startTracking")
    @Operation(
            operationId = "startFollow",
            summary = "Start following (operator)",
            description = "The drone takes off and comes. 409 when it was started already.")
    public FollowView start(@PathVariable String id) {
        return follows.start(current.principal(), id);
    }

    @PostMapping("/{id}/cancel")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @SoapName("cancelFollowRequest")
    @Operation(
            operationId = "cancelFollow",
            summary = "Cancel a follow (operator)",
            description = "Before the drone follows: it is free again. 409 once it follows; stop it then.")
    public FollowView cancel(@PathVariable String id) {
        return follows.cancel(current.principal(), id);
    }

    @PostMapping("/{id}/pause")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @SoapName("disableTracking")
    @Operation(
            operationId = "pauseFollow",
            summary = "Pause a follow (operator)",
            description = "The drone stays where it is, in the air. 409 when it does not follow.")
    public FollowView pause(@PathVariable String id) {
        return follows.pause(current.principal(), id);
    }

    @PostMapping("/{id}/continue")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @SoapName("enableTracking")
    @Operation(
            operationId = "continueFollow",
            summary = "Let a follow go on (operator)",
            description = "After a pause, or when somebody else had the drone. 409 when it is not paused.")
    public FollowView goOn(@PathVariable String id) {
        return follows.goOn(current.principal(), id);
    }

    @PostMapping("/{id}/stop")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @SoapName("stopTracking")
    @Operation(
            operationId = "stopFollow",
            summary = "Stop a follow (operator)",
            description = "The drone flies home; it is over when it is down.")
    public FollowView stop(@PathVariable String id) {
        return follows.stop(current.principal(), id);
    }
}
