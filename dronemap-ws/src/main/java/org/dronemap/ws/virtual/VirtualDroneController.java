package org.dronemap.ws.virtual;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.net.URI;
import java.util.List;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.security.CurrentPrincipal;
import org.jspecify.annotations.Nullable;
import org.springframework.http.HttpStatus;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.DeleteMapping;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.PutMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;

/** Handles virtual drones: making, changing, starting and ending their missions. */
@RestController
@RequestMapping("/api/v1/virtual-drones")
@Tag(
        name = "Virtual drones",
        description = "Planned without a drone; when the mission is started the cloud chooses the best drone of the"
                + " warehouse that is free, says why, and lets others wait in the order in which they asked.")
class VirtualDroneController {
    private final VirtualDroneService virtuals;
    private final CurrentPrincipal current;

    /** Virtual drones, the oldest first. */
    @Schema(name = "VirtualDroneList")
    public record VirtualDroneList(List<VirtualDroneView> virtualDrones) {}

    VirtualDroneController(VirtualDroneService virtuals, CurrentPrincipal current) {
        this.virtuals = virtuals;
        this.current = current;
    }

    @GetMapping
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.SHARED)
    @Operation(
            operationId = "listVirtualDrones",
            summary = "List your virtual drones",
            description = "Supervisors see those of all users.")
    public VirtualDroneList all() {
        return new VirtualDroneList(virtuals.all(current.principal()));
    }

    @GetMapping("/{id}")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.SHARED)
    @Operation(operationId = "getVirtualDrone", summary = "Look at one virtual drone")
    public VirtualDroneView one(@PathVariable String id) {
        return virtuals.one(current.principal(), id);
    }

    @PostMapping
    @Access(from = AccessLevel.PLANNER, about = ResourceScope.SHARED)
    @ResponseStatuses(201)
    @Operation(
            operationId = "addVirtualDrone",
            summary = "Make a virtual drone (planner)",
            description = "With what it needs, and its mission if it is known.")
    public ResponseEntity<VirtualDroneView> add(@RequestBody VirtualDroneRequest request) {
        VirtualDroneView added = virtuals.add(current.principal(), request);
        return ResponseEntity.created(URI.create("/api/v1/virtual-drones/" + added.id()))
                .body(added);
    }

    @PutMapping("/{id}")
    @Access(from = AccessLevel.PLANNER, about = ResourceScope.SHARED)
    @Operation(
            operationId = "replaceVirtualDrone",
            summary = "Name it, say what it needs, plan its mission (planner)",
            description = "Holds from the next start on. No drone needs to be there.")
    public VirtualDroneView replace(@PathVariable String id, @RequestBody VirtualDroneRequest request) {
        return virtuals.replace(current.principal(), id, request);
    }

    @DeleteMapping("/{id}")
    @Access(from = AccessLevel.PLANNER, about = ResourceScope.SHARED)
    @ResponseStatuses(refuses = 409)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(
            operationId = "removeVirtualDrone",
            summary = "Remove a virtual drone (planner)",
            description = "Only while its mission is not under way.")
    public void remove(@PathVariable String id) {
        virtuals.remove(current.principal(), id);
    }

    @PostMapping("/{id}/start")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @ResponseStatus(HttpStatus.ACCEPTED)
    @Operation(
            operationId = "startVirtualDrone",
            summary = "Have its mission flown (operator)",
            description = "By the best drone that is free, or by several where they may share it; else it waits, and"
                    + " its place in the queue is told.")
    public VirtualDroneView start(
            @PathVariable String id,
            @RequestBody(required = false) VirtualDroneRequest.@Nullable StartRequest request) {
        return virtuals.start(current.principal(), id, request);
    }

    @PostMapping("/{id}/stop")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @ResponseStatus(HttpStatus.ACCEPTED)
    @Operation(
            operationId = "stopVirtualDrone",
            summary = "Stop its mission (operator; supervisors any)",
            description = "All drones that serve it come home.")
    public VirtualDroneView stop(@PathVariable String id) {
        return virtuals.stop(current.principal(), id);
    }

    @PostMapping("/{id}/resume")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.SHARED)
    @ResponseStatus(HttpStatus.ACCEPTED)
    @Operation(
            operationId = "resumeVirtualDrone",
            summary = "Go on with what is not flown yet (operator)",
            description =
                    "After somebody who goes first took the drone, or drone after drone could not go on. Of several"
                            + " shares all go on that wait for it.")
    public VirtualDroneView resume(@PathVariable String id) {
        return virtuals.resume(current.principal(), id);
    }
}
