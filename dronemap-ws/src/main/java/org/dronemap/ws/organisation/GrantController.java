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

/** Handles grants of drones to users and groups. */
@RestController
@RequestMapping("/api/v1")
@Tag(
        name = "Grants",
        description = "What users and groups that see only what they were granted may do with which drones; for"
                + " administrators.")
class GrantController {
    private final GrantService grants;
    private final CurrentPrincipal current;

    /** All grants. */
    @Schema(name = "Grants")
    public record Grants(List<GrantService.GrantView> grants) {}

    GrantController(GrantService grants, CurrentPrincipal current) {
        this.grants = grants;
        this.current = current;
    }

    @GetMapping("/grants")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @Operation(operationId = "listGrants", summary = "List the grants")
    public Grants grants() {
        return new Grants(grants.grants(current.principal()));
    }

    @PostMapping("/grants")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @ResponseStatuses(value = 201, refuses = 404)
    @Operation(
            operationId = "addGrant",
            summary = "Grant something",
            description = "To a user or a group; of drones, a fleet or all; operations of view, plan, command and"
                    + " administer. It takes from what a role allows, and binds those who see only what they were"
                    + " granted.")
    public ResponseEntity<GrantService.GrantView> add(@RequestBody GrantService.GrantRequest request) {
        GrantService.GrantView made = grants.add(current.principal(), request);
        return ResponseEntity.created(URI.create("/api/v1/grants/" + made.id())).body(made);
    }

    @DeleteMapping("/grants/{id}")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(
            operationId = "revokeGrant",
            summary = "Take a grant back",
            description = "At once, on open streams too.")
    public void revoke(@PathVariable String id) {
        grants.revoke(current.principal(), id);
    }

    @PutMapping("/users/{name}/only-granted")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(
            operationId = "setUserOnlyGranted",
            summary = "Let a user see only what was granted, or all drones by the role")
    public void setUserOnlyGranted(@PathVariable String name, @RequestBody GrantService.OnlyGrantedRequest request) {
        grants.setUserOnlyGranted(current.principal(), name, request);
    }

    @PutMapping("/groups/{id}/only-granted")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(
            operationId = "setGroupOnlyGranted",
            summary = "Let the members of a group see only what was granted, or all drones by their role")
    public void setGroupOnlyGranted(@PathVariable String id, @RequestBody GrantService.OnlyGrantedRequest request) {
        grants.setGroupOnlyGranted(current.principal(), id, request);
    }
}
