package org.dronemap.ws.fence;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.tags.Tag;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.command.CommandResponse;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.security.CurrentPrincipal;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.DeleteMapping;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.PutMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RestController;

/** REST handlers for the geofence and the rally points stored on board of a vehicle. */
@RestController
@RequestMapping("/api/v1/drones/{id}")
@Tag(
        name = "Fences",
        description = "The fence and the rally points that the vehicle itself keeps; read back when changed.")
class FenceController {
    private final FenceService fences;
    private final CurrentPrincipal current;

    FenceController(FenceService fences, CurrentPrincipal current) {
        this.fences = fences;
        this.current = current;
    }

    @GetMapping("/fence")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE)
    @Operation(
            operationId = "getFence",
            summary = "Look at the fence",
            description = "As last read from the vehicle; null until it first was.")
    public FenceView fence(@PathVariable String id) {
        return fences.fence(current.principal(), id);
    }

    @PostMapping("/fence/refresh")
    @Access(from = AccessLevel.PLANNER, about = ResourceScope.DRONE)
    @ResponseStatuses(202)
    @Operation(operationId = "readFence", summary = "Read the fence from the vehicle (operator)")
    public ResponseEntity<CommandView> readFence(@PathVariable String id) {
        return CommandResponse.begun(fences.readFence(current.caller(), id));
    }

    @PutMapping("/fence")
    @Access(from = AccessLevel.PLANNER, about = ResourceScope.DRONE)
    @ResponseStatuses(202)
    @Operation(
            operationId = "setFence",
            summary = "Replace the fence (operator)",
            description =
                    "Up to 500 polygons and circles with together 2000 corners, and a return point; how many of them a"
                            + " vehicle takes is its own. What was read with something left out is refused.")
    public ResponseEntity<CommandView> setFence(@PathVariable String id, @RequestBody FenceView fence) {
        return CommandResponse.begun(fences.setFence(current.caller(), id, fence));
    }

    @PutMapping("/fence/zones")
    @Access(from = AccessLevel.PLANNER, about = ResourceScope.DRONE)
    @ResponseStatuses(202)
    @Operation(
            operationId = "setFenceFromZones",
            summary = "Make the cloud's zones the vehicle's own fence (planner)",
            description =
                    "All zones without floor and ceiling that bind this drone now, whoever flies it; they then hold"
                            + " also where the vehicle does not hear the cloud. Zones that a vehicle cannot keep are named among"
                            + " the warnings. What was its fence before is replaced.")
    public ResponseEntity<CommandView> putZonesOnBoard(@PathVariable String id) {
        return CommandResponse.begun(fences.putZonesOnBoard(current.caller(), id));
    }

    @DeleteMapping("/fence")
    @Access(from = AccessLevel.PLANNER, about = ResourceScope.DRONE)
    @ResponseStatuses(value = 202, refuses = 409)
    @Operation(operationId = "clearFence", summary = "Take the fence away (operator)")
    public ResponseEntity<CommandView> clearFence(@PathVariable String id) {
        return CommandResponse.begun(fences.clearFence(current.caller(), id));
    }

    @GetMapping("/rally-points")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE)
    @Operation(
            operationId = "getRallyPoints",
            summary = "Look at the rally points",
            description = "As last read; null until they first were.")
    public FenceView.RallyView rallyPoints(@PathVariable String id) {
        return fences.rallyPoints(current.principal(), id);
    }

    @PostMapping("/rally-points/refresh")
    @Access(from = AccessLevel.PLANNER, about = ResourceScope.DRONE)
    @ResponseStatuses(202)
    @Operation(operationId = "readRallyPoints", summary = "Read the rally points from the vehicle (operator)")
    public ResponseEntity<CommandView> readRallyPoints(@PathVariable String id) {
        return CommandResponse.begun(fences.readRallyPoints(current.caller(), id));
    }

    @PutMapping("/rally-points")
    @Access(from = AccessLevel.PLANNER, about = ResourceScope.DRONE)
    @ResponseStatuses(202)
    @Operation(
            operationId = "setRallyPoints",
            summary = "Replace the rally points (operator)",
            description =
                    "Up to 250, each with what its altitude is measured from. What was read with something left out"
                            + " is refused.")
    public ResponseEntity<CommandView> setRallyPoints(
            @PathVariable String id, @RequestBody FenceView.RallyView points) {
        return CommandResponse.begun(fences.setRallyPoints(current.caller(), id, points));
    }

    @DeleteMapping("/rally-points")
    @Access(from = AccessLevel.PLANNER, about = ResourceScope.DRONE)
    @ResponseStatuses(value = 202, refuses = 409)
    @Operation(operationId = "clearRallyPoints", summary = "Take the rally points away (operator)")
    public ResponseEntity<CommandView> clearRallyPoints(@PathVariable String id) {
        return CommandResponse.begun(fences.clearRallyPoints(current.caller(), id));
    }
}
