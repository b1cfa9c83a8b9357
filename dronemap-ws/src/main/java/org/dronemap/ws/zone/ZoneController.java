package org.dronemap.ws.zone;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.net.URI;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.RequestCost;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.http.FileMediaTypes;
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

/** REST handlers for the zones of the cloud (areas that drones stay in or out of), as GeoJSON. */
@RestController
@RequestMapping("/api/v1/zones")
@Tag(
        name = "Zones",
        description = "Areas of the cloud that drones stay in or out of: every way is checked against them before it is"
                + " sent, and flights are watched. Not the fence that a vehicle keeps itself.")
class ZoneController {
    private final ZoneService zones;
    private final CurrentPrincipal current;

    ZoneController(ZoneService zones, CurrentPrincipal current) {
        this.zones = zones;
        this.current = current;
    }

    @GetMapping
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.SHARED)
    @Operation(operationId = "listZones", summary = "List the zones", description = "A GeoJSON FeatureCollection.")
    public ZoneFeature.ZoneCollection zones() {
        return zones.zones(current.principal());
    }

    @GetMapping("/{id}")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.SHARED)
    @Operation(operationId = "getZone", summary = "Look at one zone")
    public ZoneFeature zone(@PathVariable String id) {
        return zones.zone(current.principal(), id);
    }

    @PostMapping
    @Access(from = AccessLevel.SUPERVISOR, about = ResourceScope.ORGANISATION)
    @ResponseStatuses(201)
    @Operation(
            operationId = "addZone",
            summary = "Add a zone (supervisor)",
            description = "A GeoJSON feature: a Polygon with one ring, or a Point with properties.radius.")
    public ResponseEntity<ZoneFeature> add(@RequestBody ZoneFeature zone) {
        ZoneFeature added = zones.add(current.principal(), zone);
        return ResponseEntity.created(URI.create("/api/v1/zones/" + added.id())).body(added);
    }

    @PostMapping("/import")
    @Access(from = AccessLevel.SUPERVISOR, about = ResourceScope.ORGANISATION, costs = RequestCost.EXPORT)
    @ResponseStatus(HttpStatus.CREATED)
    @FileMediaTypes(
            consumes = {
                "application/geo+json",
                "application/vnd.google-earth.kml+xml",
                "application/vnd.google-earth.kmz"
            })
    @Operation(
            operationId = "importZones",
            summary = "Add the zones of a GeoJSON, KML or KMZ file (supervisor)",
            description =
                    "Up to 4 MB. What cannot be a zone, such as a line, is left out and named with the reason, and"
                            + " the rest is added; a file without any is refused. Members of other programs are passed over, a"
                            + " MultiPolygon becomes several zones, what has no name gets one.")
    public ZoneImportView importZones(@RequestBody byte[] file) {
        return zones.importZones(current.principal(), file);
    }

    @PutMapping("/{id}")
    @Access(from = AccessLevel.SUPERVISOR, about = ResourceScope.ORGANISATION)
    @ResponseStatuses(never = 409)
    @Operation(
            operationId = "replaceZone",
            summary = "Replace a zone (supervisor)",
            description = "Binds at once, drones in flight too.")
    public ZoneFeature replace(@PathVariable String id, @RequestBody ZoneFeature zone) {
        return zones.replace(current.principal(), id, zone);
    }

    @DeleteMapping("/{id}")
    @Access(from = AccessLevel.SUPERVISOR, about = ResourceScope.ORGANISATION)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(operationId = "deleteZone", summary = "Remove a zone (supervisor)")
    public void delete(@PathVariable String id) {
        zones.delete(current.principal(), id);
    }
}
