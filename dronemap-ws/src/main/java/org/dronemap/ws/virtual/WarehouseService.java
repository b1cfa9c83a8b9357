package org.dronemap.ws.virtual;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.Comparator;
import java.util.List;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.conduct.VirtualDroneMatch;
import org.dronemap.core.conduct.VirtualDrones;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.virtual.UnfitReason;
import org.dronemap.core.virtual.VirtualDrone;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.CommandProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.jspecify.annotations.Nullable;

/** Puts real drones into the warehouse and takes them out: those that may be flown unattended for virtual drones. */
public final class WarehouseService {
    private final VirtualDrones virtuals;
    private final DroneService drones;

    /** Drones that may serve virtual ones. */
    @Schema(name = "WarehouseView")
    public record WarehouseView(List<VirtualDroneView.DroneName> drones) {}

    public WarehouseService(VirtualDrones virtuals, DroneService drones) {
        this.virtuals = virtuals;
        this.drones = drones;
    }

    /** Those that the asker may see. */
    public WarehouseView warehouse(Principal principal) {
        RoleChecks.require(principal, Role.VIEWER);
        return new WarehouseView(virtuals.warehouse().stream()
                .flatMap(id -> drones.find(principal, id.value()).stream())
                .map(drone -> new VirtualDroneView.DroneName(drone.id().value(), drone.name()))
                .sorted(Comparator.comparing(VirtualDroneView.DroneName::name))
                .toList());
    }

    /**
     * Virtual drone that waits for a drone, the first in turn first; {@code flies}: this drone would arm and take off
     * for it at once, were it in the warehouse and nobody had control of it. {@code name} and {@code owner} are null
     * for those who may not see it.
     */
    @Schema(name = "WarehouseProspectView")
    public record ProspectView(
            @Nullable String name,
            @Nullable String owner,
            int waypoints,
            boolean flies,
            @Nullable String why,

            @Schema(description = "The same for programs; docs/problems.md lists them") @Nullable
            String code) {}

    /** The waiting ones; of several that it could serve it flies the first, and the others after it. */
    @Schema(name = "WarehouseProspectsView")
    public record ProspectsView(boolean inWarehouse, List<ProspectView> waiting) {}

    /** What would follow if that drone were put there, or left to itself while it is there. Changes nothing. */
    public ProspectsView prospects(Principal principal, String id) {
        DroneState drone = drones.state(principal, id, Role.OPERATOR);
        List<ProspectView> waiting = drone.replay()
                ? List.of()
                : virtuals.prospects(drone).stream()
                        .map(prospect -> view(principal, prospect))
                        .toList();
        return new ProspectsView(virtuals.warehouse().contains(drone.id()), waiting);
    }

    private static ProspectView view(Principal principal, VirtualDroneMatch prospect) {
        VirtualDrone waiting = prospect.waiting();
        boolean shown = VirtualDroneService.isShownTo(principal, waiting);
        return new ProspectView(
                shown ? waiting.name() : null,
                shown ? waiting.owner() : null,
                prospect.share().total() - prospect.share().flown(),
                prospect.whyNot().isEmpty(),
                prospect.whyNot().map(UnfitReason::sentence).orElse(null),
                prospect.whyNot().map(UnfitReason::code).orElse(null));
    }

    public WarehouseView put(Principal principal, String id) {
        DroneState drone = known(principal, id);
        if (principal.scope().isBounded()) {
            throw Rejection.of(
                    AccessProblem.KEY_BOUNDED,
                    "This access key has an area or heights, and a drone in the warehouse flies without them.");
        }
        if (drone.replay()) {
            throw Rejection.of(
                    new CommandProblem(OutcomeCode.DRONE_IS_A_RECORDING),
                    "This is a recording; it cannot fly.",
                    ProblemParameter.DRONE.is(drone.id().value()));
        }
        virtuals.addToWarehouse(drone.id());
        return warehouse(principal);
    }

    /** What it serves now it serves to the end. */
    public void remove(Principal principal, String id) {
        virtuals.removeFromWarehouse(known(principal, id).id());
    }

    private DroneState known(Principal principal, String id) {
        return drones.state(principal, id, Role.SUPERVISOR);
    }
}
