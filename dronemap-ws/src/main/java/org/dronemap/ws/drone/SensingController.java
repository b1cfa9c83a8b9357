package org.dronemap.ws.drone;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.util.Optional;
import org.dronemap.core.drone.Picture;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.http.FileMediaTypes;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.security.CurrentPrincipal;
import org.springframework.http.CacheControl;
import org.springframework.http.MediaType;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RestController;

/** REST handlers for the latest sensor readings of a drone: laser scan, camera picture and map. */
@RestController
@RequestMapping("/api/v1/drones/{id}/sensed")
@Tag(name = "Sensors", description = "The newest sweep of its range finder, picture of its camera and map of a drone.")
class SensingController {
    private final SensingService sensing;
    private final CurrentPrincipal current;

    SensingController(SensingService sensing, CurrentPrincipal current) {
        this.sensing = sensing;
        this.current = current;
    }

    @GetMapping
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE)
    @Operation(
            operationId = "getSensed",
            summary = "Look at what its sensors brought last",
            description = "Each kind is counted; the drone in the stream says the newest numbers.")
    public SensingView sensed(@PathVariable String id) {
        return sensing.sensed(current.principal(), id);
    }

    @GetMapping("/picture")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE)
    @ResponseStatuses({200, 204})
    @FileMediaTypes(produces = {"image/jpeg", "image/png"})
    @Operation(
            operationId = "getSensedPicture",
            summary = "The newest picture of its camera",
            description = "JPEG or PNG; 204 when there was none yet.")
    public ResponseEntity<byte[]> picture(@PathVariable String id) {
        return answer(sensing.picture(current.principal(), id));
    }

    @GetMapping("/map")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE)
    @ResponseStatuses({200, 204})
    @FileMediaTypes(produces = {"image/jpeg", "image/png"})
    @Operation(
            operationId = "getSensedMap",
            summary = "Its map, drawn from above",
            description = "JPEG or PNG; 204 when there was none yet.")
    public ResponseEntity<byte[]> map(@PathVariable String id) {
        return answer(sensing.map(current.principal(), id));
    }

    private static ResponseEntity<byte[]> answer(Optional<Picture> picture) {
        return picture.map(found -> ResponseEntity.ok()
                        .contentType(MediaType.parseMediaType(found.mediaType()))
                        .cacheControl(CacheControl.noStore())
                        .body(found.bytes()))
                .orElseGet(() -> ResponseEntity.noContent().build());
    }
}
