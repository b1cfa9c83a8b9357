package org.dronemap.ws.drone;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.util.List;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.access.SoapName;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.security.CurrentPrincipal;
import org.springframework.http.HttpStatus;
import org.springframework.web.bind.annotation.DeleteMapping;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PatchMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;

/** REST handlers that list, show, rename and remove drones. */
@RestController
@RequestMapping("/api/v1/drones")
@Tag(name = "Drones", description = "Every vehicle that the cloud knows, with its state now.")
class DroneController {
    private final DroneService drones;
    private final CurrentPrincipal current;

    /** All drones. */
    @Schema(name = "Drones")
    public record Drones(List<DroneView> drones) {}

    DroneController(DroneService drones, CurrentPrincipal current) {
        this.drones = drones;
        this.current = current;
    }

    @GetMapping
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE)
    @SoapName("getDronesList")
    @Operation(operationId = "listDrones", summary = "List the drones")
    public Drones drones(
            @Parameter(description = "true: only those that are heard now") @RequestParam(defaultValue = "false")
                    boolean active) {
        return new Drones(active ? drones.activeDrones(current.principal()) : drones.drones(current.principal()));
    }

    @GetMapping("/{id}")
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE)
    @Operation(operationId = "getDrone", summary = "Look at one drone")
    public DroneView drone(@PathVariable String id) {
        return drones.drone(current.principal(), id);
    }

    @PatchMapping("/{id}")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.DRONE)
    @ResponseStatuses(never = 409)
    @Operation(operationId = "renameDrone", summary = "Give a drone another name (operator)")
    public DroneView rename(@PathVariable String id, @RequestBody RenameRequest request) {
        return drones.rename(current.principal(), id, request);
    }

    @DeleteMapping("/{id}")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.DRONE)
    @ResponseStatuses(refuses = 409)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(operationId = "removeDrone", summary = "Forget a lost drone (administrator)")
    public void remove(@PathVariable String id) {
        drones.remove(current.principal(), id);
    }
}
