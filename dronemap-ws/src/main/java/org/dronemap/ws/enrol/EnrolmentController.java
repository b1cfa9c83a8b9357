package org.dronemap.ws.enrol;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.net.URI;
import java.util.List;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.drone.DroneView;
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
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;

/** REST handlers that list unknown vehicles waiting at an endpoint, and enrol them as drones or dismiss them. */
@RestController
@RequestMapping("/api/v1/waiting")
@Tag(name = "Enrolment", description = "Vehicles that nobody knows yet, and such as say they are who they are not.")
class EnrolmentController {
    private final EnrolmentService waiting;
    private final CurrentPrincipal current;

    /** All who wait. */
    @Schema(name = "Waitings")
    public record PendingVehicles(List<PendingVehicleView> waiting) {}

    EnrolmentController(EnrolmentService waiting, CurrentPrincipal current) {
        this.waiting = waiting;
        this.current = current;
    }

    @GetMapping
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.SERVER)
    @Operation(operationId = "listWaiting", summary = "List the vehicles that wait (administrator)")
    public PendingVehicles waiting() {
        return new PendingVehicles(waiting.waiting(current.principal()));
    }

    @PostMapping("/{id}/enrol")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.SERVER)
    @ResponseStatuses(value = 201, never = 409)
    @Operation(operationId = "enrolWaiting", summary = "Let a vehicle in as a drone (administrator)")
    public ResponseEntity<DroneView> enrol(
            @PathVariable String id, @RequestBody(required = false) EnrolmentService.@Nullable EnrolRequest request) {
        DroneView drone =
                waiting.enrol(current.principal(), id, request == null ? EnrolmentService.EnrolRequest.PLAIN : request);
        return ResponseEntity.status(HttpStatus.CREATED)
                .location(URI.create("/api/v1/drones/" + drone.id()))
                .body(drone);
    }

    @DeleteMapping("/{id}")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.SERVER)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(
            operationId = "dismissWaiting",
            summary = "Take a vehicle off the list (administrator)",
            description = "It comes again when it is heard.")
    public void dismiss(@PathVariable String id) {
        waiting.dismiss(current.principal(), id);
    }
}
