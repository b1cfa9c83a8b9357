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
import org.jspecify.annotations.Nullable;
import org.springframework.http.HttpStatus;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.DeleteMapping;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PatchMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.PutMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;

/** REST handlers for organisations and for drones transferred between them, for administrators of the server. */
@RestController
@RequestMapping("/api/v1/organisations")
@Tag(
        name = "Organisations",
        description = "People and drones that belong together and see nothing of other organisations; for the"
                + " administrators of the server.")
class OrganisationController {
    private final OrganisationService organisations;
    private final GiftService gifts;
    private final CurrentPrincipal current;

    /** All of them. */
    @Schema(name = "Organisations")
    public record Organisations(List<OrganisationService.OrganisationView> organisations) {}

    OrganisationController(OrganisationService organisations, GiftService gifts, CurrentPrincipal current) {
        this.organisations = organisations;
        this.gifts = gifts;
        this.current = current;
    }

    @GetMapping
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.SERVER)
    @Operation(
            operationId = "listOrganisations",
            summary = "List the organisations",
            description = "With how many users and drones each has.")
    public Organisations organisations() {
        return new Organisations(organisations.organisations(current.principal()));
    }

    @PostMapping
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.SERVER)
    @ResponseStatuses(201)
    @Operation(
            operationId = "addOrganisation",
            summary = "Make an organisation",
            description = "Its first administrator comes by an invitation into it (POST /invitations).")
    public ResponseEntity<OrganisationService.OrganisationView> add(
            @RequestBody OrganisationService.NameRequest request) {
        OrganisationService.OrganisationView made = organisations.add(current.principal(), request);
        return ResponseEntity.created(URI.create("/api/v1/organisations/" + made.id()))
                .body(made);
    }

    @PatchMapping("/{id}")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.SERVER)
    @Operation(operationId = "renameOrganisation", summary = "Rename an organisation")
    public OrganisationService.OrganisationView rename(
            @PathVariable String id, @RequestBody OrganisationService.NameRequest request) {
        return organisations.rename(current.principal(), id, request);
    }

    @GetMapping("/{id}/drones")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.SERVER)
    @Operation(
            operationId = "listGivenDrones",
            summary = "List the drones that were given to an organisation and that it still has",
            description = "As they were called when they were given.")
    public GiftService.Gifts gifts(@PathVariable String id) {
        return gifts.gifts(current.principal(), id);
    }

    @PutMapping("/{id}/drones/{drone}")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.SERVER)
    @Operation(
            operationId = "giveDrone",
            summary = "Give a drone of your own organisation to another one",
            description =
                    "On the ground, disarmed, and out of every operation and the warehouse. Only its new owners see"
                            + " it from then on. Flights, recordings, commands and telemetry of before stay with those who had it, and"
                            + " go along as well if histories says so, but never with names of people. What is on board goes along,"
                            + " and the keys of the vehicle still hold: change them.")
    public GiftService.GiftView giveDrone(
            @PathVariable String id,
            @PathVariable String drone,
            @RequestBody(required = false) GiftService.@Nullable GiftRequest request) {
        return gifts.give(current.principal(), id, drone, request);
    }

    @DeleteMapping("/{id}/drones/{drone}")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.SERVER)
    @ResponseStatuses(refuses = 409)
    @Operation(
            operationId = "takeBackDrone",
            summary = "Take a drone back that was given to an organisation",
            description =
                    "On the ground, disarmed, and out of every operation and the warehouse. What it did meanwhile is"
                            + " shown to those who had it then, alone.")
    public GiftService.GiftView reclaimDrone(@PathVariable String id, @PathVariable String drone) {
        return gifts.revoke(current.principal(), id, drone);
    }

    @DeleteMapping("/{id}")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.SERVER)
    @ResponseStatuses(refuses = 409)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(operationId = "deleteOrganisation", summary = "Remove an organisation that has neither users nor drones")
    public void delete(@PathVariable String id) {
        organisations.delete(current.principal(), id);
    }
}
