package org.dronemap.ws.organisation;

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

/** REST handlers for named groups of users and named fleets of drones. */
@RestController
@RequestMapping("/api/v1")
@Tag(name = "Groups and fleets", description = "Named sets of users and of drones; for administrators.")
class GroupController {
    private final GroupService groups;
    private final CurrentPrincipal current;

    /** All groups. */
    @Schema(name = "Groups")
    public record Groups(List<GroupService.GroupView> groups) {}

    /** All fleets. */
    @Schema(name = "Fleets")
    public record Fleets(List<GroupService.FleetView> fleets) {}

    GroupController(GroupService groups, CurrentPrincipal current) {
        this.groups = groups;
        this.current = current;
    }

    @GetMapping("/groups")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @Operation(operationId = "listGroups", summary = "List the groups of users")
    public Groups groups() {
        return new Groups(groups.groups(current.principal()));
    }

    @PostMapping("/groups")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @ResponseStatuses(201)
    @Operation(operationId = "addGroup", summary = "Make a group of users")
    public ResponseEntity<GroupService.GroupView> addGroup(@RequestBody GroupService.GroupRequest request) {
        GroupService.GroupView made = groups.addGroup(current.principal(), request);
        return ResponseEntity.created(URI.create("/api/v1/groups/" + made.id())).body(made);
    }

    @PutMapping("/groups/{id}")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @Operation(operationId = "replaceGroup", summary = "Change the name and the members of a group")
    public GroupService.GroupView replaceGroup(
            @PathVariable String id, @RequestBody GroupService.GroupRequest request) {
        return groups.replaceGroup(current.principal(), id, request);
    }

    @DeleteMapping("/groups/{id}")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(operationId = "deleteGroup", summary = "Remove a group, with what was granted to it")
    public void deleteGroup(@PathVariable String id) {
        groups.deleteGroup(current.principal(), id);
    }

    @GetMapping("/fleets")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @Operation(operationId = "listFleets", summary = "List the fleets")
    public Fleets fleets() {
        return new Fleets(groups.fleets(current.principal()));
    }

    @PostMapping("/fleets")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @ResponseStatuses(201)
    @Operation(operationId = "addFleet", summary = "Make a fleet of drones")
    public ResponseEntity<GroupService.FleetView> addFleet(@RequestBody GroupService.FleetRequest request) {
        GroupService.FleetView made = groups.addFleet(current.principal(), request);
        return ResponseEntity.created(URI.create("/api/v1/fleets/" + made.id())).body(made);
    }

    @PutMapping("/fleets/{id}")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @ResponseStatuses(never = 409)
    @Operation(operationId = "replaceFleet", summary = "Change the name and the drones of a fleet")
    public GroupService.FleetView replaceFleet(
            @PathVariable String id, @RequestBody GroupService.FleetRequest request) {
        return groups.replaceFleet(current.principal(), id, request);
    }

    @DeleteMapping("/fleets/{id}")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(operationId = "deleteFleet", summary = "Remove a fleet, with all grants of it")
    public void deleteFleet(@PathVariable String id) {
        groups.deleteFleet(current.principal(), id);
    }
}
