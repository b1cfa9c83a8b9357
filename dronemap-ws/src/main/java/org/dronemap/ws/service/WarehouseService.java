package org.dronemap.ws.service;

import java.util.Comparator;
import java.util.List;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.conduct.VirtualDrones;
import org.dronemap.core.drone.DroneState;

/** Use cases around the warehouse: the drones that may be armed and flown for virtual ones without anybody beside them. */
public final class WarehouseService {
    private final VirtualDrones virtuals;
    private final DroneService drones;

    /** Drones that may serve virtual ones. */
    public record WarehouseView(List<VirtualDroneView.DroneName> drones) {}

    public WarehouseService(VirtualDrones virtuals, DroneService drones) {
        this.virtuals = virtuals;
        this.drones = drones;
    }

    /** Those that the asker may see. */
    public WarehouseView warehouse(Principal principal) {
        Roles.require(principal, Role.VIEWER);
        return new WarehouseView(virtuals.warehouse().stream()
                .flatMap(id -> drones.find(principal, id.value()).stream())
                .map(drone -> new VirtualDroneView.DroneName(drone.id().value(), drone.name()))
                .sorted(Comparator.comparing(VirtualDroneView.DroneName::name))
                .toList());
    }

    public WarehouseView put(Principal principal, String id) {
        DroneState drone = known(principal, id);
        if (principal.scope().isBounded()) {
            throw Rejection.forbidden(
                    "This access key has an area or heights, and a drone in the warehouse flies without them.");
        }
        if (drone.replay()) {
            throw Rejection.conflict("This is a recording; it cannot fly.");
        }
        virtuals.putIntoWarehouse(drone.id());
        return warehouse(principal);
    }

    /** What it serves now it serves to the end. */
    public void take(Principal principal, String id) {
        virtuals.takeOutOfWarehouse(known(principal, id).id());
    }

    private DroneState known(Principal principal, String id) {
        return drones.state(principal, id, Role.SUPERVISOR);
    }
}
