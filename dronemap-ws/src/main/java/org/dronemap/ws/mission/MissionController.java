package org.dronemap.ws.mission;

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

/** REST handlers for the mission library: missions saved on the server, not those on a vehicle. */
@RestController
@RequestMapping("/api/v1/missions")
@Tag(name = "Missions", description = "Missions kept in the cloud, ready to be uploaded to a drone.")
class MissionController {
    private final MissionService missions;
    private final CurrentPrincipal current;

    /** All saved missions. */
    @Schema(name = "Missions")
    public record Missions(List<MissionService.SavedMissionView> missions) {}

    MissionController(MissionService missions, CurrentPrincipal current) {
        this.missions = missions;
        this.current = current;
    }

    @GetMapping
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.SHARED)
    @Operation(operationId = "listMissions", summary = "List the saved missions")
    public Missions missions() {
        return new Missions(missions.missions(current.principal()));
    }

    @GetMapping("/{id}")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.SHARED)
    @Operation(operationId = "getMission", summary = "Look at one saved mission")
    public MissionService.SavedMissionView mission(@PathVariable String id) {
        return missions.mission(current.principal(), id);
    }

    @PostMapping
    @Access(from = AccessLevel.PLANNER, about = ResourceScope.SHARED)
    @ResponseStatuses(value = 201, never = 409)
    @Operation(operationId = "addMission", summary = "Save a mission (operator)")
    public ResponseEntity<MissionService.SavedMissionView> add(@RequestBody MissionService.MissionRequest request) {
        MissionService.SavedMissionView saved = missions.add(current.principal(), request);
        return ResponseEntity.created(URI.create("/api/v1/missions/" + saved.id()))
                .body(saved);
    }

    @PutMapping("/{id}")
    @Access(from = AccessLevel.PLANNER, about = ResourceScope.SHARED)
    @ResponseStatuses(never = 409)
    @Operation(operationId = "replaceMission", summary = "Replace a saved mission (operator)")
    public MissionService.SavedMissionView replace(
            @PathVariable String id, @RequestBody MissionService.MissionRequest request) {
        return missions.replace(current.principal(), id, request);
    }

    @DeleteMapping("/{id}")
    @Access(from = AccessLevel.PLANNER, about = ResourceScope.SHARED)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(operationId = "deleteMission", summary = "Remove a saved mission (operator)")
    public void delete(@PathVariable String id) {
        missions.delete(current.principal(), id);
    }
}
