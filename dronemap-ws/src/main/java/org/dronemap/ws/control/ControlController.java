package org.dronemap.ws.control;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.tags.Tag;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.AuditPolicy;
import org.dronemap.ws.access.RequestCost;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.drone.ControlView;
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
import org.springframework.web.bind.annotation.RestController;

/** Handles taking, requesting, handing over and releasing the control of a drone. */
@RestController
@RequestMapping("/api/v1/drones/{id}/control")
@Tag(
        name = "Control",
        description = "One user commands a drone at a time. The first command takes control where it is free; taken on"
                + " purpose it is kept by a heartbeat every 2 s. 409 says who has control and since when.")
class ControlController {
    private final ControlService controls;
    private final CurrentPrincipal current;

    ControlController(ControlService controls, CurrentPrincipal current) {
        this.controls = controls;
        this.current = current;
    }

    @GetMapping
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE)
    @Operation(operationId = "getControl", summary = "See who has control")
    public ControlView control(@PathVariable String id) {
        return controls.control(current.principal(), id);
    }

    @PostMapping("/take")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.DRONE, costs = RequestCost.NOTHING)
    @Operation(
            operationId = "takeControl",
            summary = "Take control where nobody has it (operator)",
            description = "Also back from the pilot at the vehicle. Send the heartbeat every 2 s from then on.")
    public ResponseEntity<ControlView> takeControl(@PathVariable String id) {
        return act(id, new ControlRequest.TakeControl());
    }

    @PostMapping("/request")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.DRONE, costs = RequestCost.NOTHING)
    @ResponseStatuses({200, 202})
    @Operation(
            operationId = "requestControl",
            summary = "Ask the holder for control (operator)",
            description = "202 while the holder decides, for up to a minute; 200 where control was free.")
    public ResponseEntity<ControlView> request(
            @PathVariable String id, @RequestBody(required = false) ControlRequest.@Nullable Ask asked) {
        return act(id, asked == null ? new ControlRequest.Ask(null) : asked);
    }

    @PostMapping("/grant")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.DRONE, costs = RequestCost.NOTHING)
    @Operation(operationId = "grantControl", summary = "Give control to somebody who asks for it (holder)")
    public ResponseEntity<ControlView> grant(@PathVariable String id, @RequestBody ControlRequest.Grant with) {
        return act(id, with);
    }

    @PostMapping("/refuse")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.DRONE, costs = RequestCost.NOTHING)
    @Operation(operationId = "refuseControl", summary = "Keep control from somebody who asks for it (holder)")
    public ResponseEntity<ControlView> refuse(@PathVariable String id, @RequestBody ControlRequest.Refuse with) {
        return act(id, with);
    }

    @PostMapping("/hand-over")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.DRONE, costs = RequestCost.NOTHING)
    @Operation(
            operationId = "handOverControl",
            summary = "Give control to somebody (holder)",
            description = "They keep it for 30 s, or by using it.")
    public ResponseEntity<ControlView> handOver(@PathVariable String id, @RequestBody ControlRequest.HandOver with) {
        return act(id, with);
    }

    @PostMapping("/take-over")
    @Access(from = AccessLevel.SUPERVISOR, about = ResourceScope.DRONE, costs = RequestCost.NOTHING)
    @Operation(
            operationId = "takeOverControl",
            summary = "Take control from whoever has it, with a reason (supervisor)")
    public ResponseEntity<ControlView> takeOver(@PathVariable String id, @RequestBody ControlRequest.TakeOver with) {
        return act(id, with);
    }

    @PostMapping("/heartbeat")
    @Access(
            from = AccessLevel.OPERATOR,
            about = ResourceScope.DRONE,
            costs = RequestCost.NOTHING,
            audit = AuditPolicy.LEFT_OUT)
    @Operation(
            operationId = "keepControl",
            summary = "Say that the holder is there (holder)",
            description = "Every 2 s; lost after 6 s without.")
    public ResponseEntity<ControlView> heartbeat(@PathVariable String id, @RequestBody ControlRequest.Heartbeat with) {
        return act(id, with);
    }

    @DeleteMapping
    @Access(from = AccessLevel.PLANNER, about = ResourceScope.DRONE, costs = RequestCost.NOTHING)
    @ResponseStatuses(refuses = 409)
    @Operation(operationId = "releaseControl", summary = "Give control back (holder)")
    public ResponseEntity<ControlView> release(@PathVariable String id) {
        return act(id, new ControlRequest.Release());
    }

    private ResponseEntity<ControlView> act(String id, ControlRequest request) {
        ControlService.Answer answer = controls.act(current.principal(), id, request);
        return ResponseEntity.status(answer.waiting() ? HttpStatus.ACCEPTED : HttpStatus.OK)
                .body(answer.control());
    }
}
