package org.dronemap.ws.link;

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
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;

/** REST handlers for the endpoints that vehicles connect to, their traffic, and the DTLS keys of vehicles. */
@RestController
@RequestMapping("/api/v1")
@Tag(name = "Links", description = "Ways in for vehicles and their counters (administrator).")
class EndpointController {
    private final EndpointService links;
    private final DtlsKeyService keys;
    private final CurrentPrincipal current;

    /** All endpoints. */
    @Schema(name = "Endpoints")
    public record Endpoints(List<EndpointView> endpoints) {}

    /** The traffic of all vehicles. */
    @Schema(name = "LinkTraffic")
    public record Traffic(List<LinkTrafficView> vehicles) {}

    /** All DTLS keys. */
    @Schema(name = "DtlsKeys")
    public record DtlsKeys(List<DtlsKeyService.DtlsKeyView> dtlsKeys) {}

    EndpointController(EndpointService links, DtlsKeyService keys, CurrentPrincipal current) {
        this.links = links;
        this.keys = keys;
        this.current = current;
    }

    @GetMapping("/endpoints")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.SERVER)
    @Operation(
            operationId = "listEndpoints",
            summary = "List the endpoints with their state and counters (administrator)")
    public Endpoints endpoints() {
        return new Endpoints(links.endpoints(current.principal()));
    }

    @GetMapping("/endpoints/{id}")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.SERVER)
    @Operation(operationId = "getEndpoint", summary = "Look at one endpoint (administrator)")
    public EndpointView endpoint(@PathVariable String id) {
        return links.endpoint(current.principal(), id);
    }

    @PostMapping("/endpoints")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.SERVER)
    @ResponseStatuses(201)
    @Operation(
            operationId = "addEndpoint",
            summary = "Add an endpoint (administrator)",
            description = "It stays over restarts. While it cannot open it is listed as failed, and tried again.")
    public ResponseEntity<EndpointView> add(@RequestBody EndpointService.EndpointRequest request) {
        EndpointView endpoint = links.add(current.principal(), request);
        return ResponseEntity.created(URI.create("/api/v1/endpoints/" + endpoint.id()))
                .body(endpoint);
    }

    @DeleteMapping("/endpoints/{id}")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.SERVER)
    @ResponseStatuses(refuses = 409)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(operationId = "removeEndpoint", summary = "Remove an endpoint that was added (administrator)")
    public void remove(@PathVariable String id) {
        links.remove(current.principal(), id);
    }

    @GetMapping("/traffic")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.SERVER)
    @Operation(operationId = "getTraffic", summary = "What went over the link of each vehicle (administrator)")
    public Traffic traffic() {
        return new Traffic(links.traffic(current.principal()));
    }

    @GetMapping("/dtls-keys")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.SERVER)
    @Operation(operationId = "listDtlsKeys", summary = "List the DTLS keys of vehicles (administrator)")
    public DtlsKeys dtlsKeys() {
        return new DtlsKeys(keys.keys(current.principal()));
    }

    @PostMapping("/dtls-keys")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.SERVER)
    @ResponseStatuses(value = 201, refuses = 404, never = 409)
    @Operation(
            operationId = "makeDtlsKey",
            summary = "Make the DTLS key of a vehicle (administrator)",
            description = "The secret is in this answer and never shown again; a drone's key before is void.")
    public ResponseEntity<DtlsKeyService.DtlsKeyView> makeKey(@RequestBody DtlsKeyService.DtlsKeyRequest request) {
        DtlsKeyService.DtlsKeyView key = keys.make(current.principal(), request);
        return ResponseEntity.created(URI.create("/api/v1/dtls-keys/" + key.identity()))
                .body(key);
    }

    @DeleteMapping("/dtls-keys/{identity}")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.SERVER)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(
            operationId = "deleteDtlsKey",
            summary = "Revoke the DTLS key of a vehicle; its links end at once (administrator)")
    public void revoke(@PathVariable String identity) {
        keys.revoke(current.principal(), identity);
    }
}
