package org.dronemap.ws.virtual;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.tags.Tag;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.security.CurrentPrincipal;
import org.springframework.http.HttpStatus;
import org.springframework.web.bind.annotation.DeleteMapping;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PutMapping;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;

/** REST handlers for the warehouse: the real drones that may serve virtual drones. */
@RestController
@RequestMapping("/api/v1/warehouse")
@Tag(
        name = "Warehouse",
        description = "Drones that may be armed and flown for virtual ones with nobody beside them; no drone is in it"
                + " until a supervisor puts it there.")
class WarehouseController {
    private final WarehouseService warehouse;
    private final CurrentPrincipal current;

    WarehouseController(WarehouseService warehouse, CurrentPrincipal current) {
        this.warehouse = warehouse;
        this.current = current;
    }

    @GetMapping
    @Access(from = AccessLevel.VIEWER, about = ResourceScope.DRONE)
    @Operation(
            operationId = "listWarehouse",
            summary = "List the drones of the warehouse",
            description = "Those that you may see.")
    public WarehouseService.WarehouseView all() {
        return warehouse.warehouse(current.principal());
    }

    @GetMapping("/{id}/prospects")
    @Access(from = AccessLevel.OPERATOR, about = ResourceScope.DRONE)
    @Operation(
            operationId = "getProspects",
            summary = "What would follow if a drone were put into the warehouse (operator)",
            description =
                    "What waits for a drone, the first in turn first, and what this one would arm and take off for at"
                            + " once. The same follows when control of a drone of the warehouse is given back. Changes nothing.")
    public WarehouseService.ProspectsView prospects(@PathVariable String id) {
        return warehouse.prospects(current.principal(), id);
    }

    @PutMapping("/{id}")
    @Access(from = AccessLevel.SUPERVISOR, about = ResourceScope.DRONE)
    @Operation(operationId = "putIntoWarehouse", summary = "Let a drone serve virtual ones (supervisor)")
    public WarehouseService.WarehouseView put(@PathVariable String id) {
        return warehouse.put(current.principal(), id);
    }

    @DeleteMapping("/{id}")
    @Access(from = AccessLevel.SUPERVISOR, about = ResourceScope.DRONE)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(
            operationId = "takeFromWarehouse",
            summary = "Let a drone serve virtual ones no more (supervisor)",
            description = "What it serves now it serves to the end.")
    public void remove(@PathVariable String id) {
        warehouse.remove(current.principal(), id);
    }
}
