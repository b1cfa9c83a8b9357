package org.dronemap.ws.enrol;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Size;
import java.util.List;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.drone.DroneView;
import org.dronemap.ws.drone.DroneViewMapper;
import org.dronemap.ws.organisation.OrganisationService;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.reading.NameRules;
import org.jspecify.annotations.Nullable;

/** Lists unknown vehicles waiting for an administrator, who enrols them as drones or dismisses them. Any thread. */
public final class EnrolmentService {
    private static final int LONGEST_NAME = 60;

    private final CloudManager cloud;
    private final DroneViewMapper views;
    private final OrganisationService organisations;

    /** Request to enrol a vehicle as a drone; without a name it is called by vehicle type and MAVLink system id. */
    @Schema(name = "EnrolRequest")
    public record EnrolRequest(
            @Size(min = 1, max = LONGEST_NAME) @Nullable String name,
            @Nullable String organisation) {
        public static final EnrolRequest PLAIN = new EnrolRequest(null, null);
    }

    public EnrolmentService(CloudManager cloud, DroneViewMapper views, OrganisationService organisations) {
        this.cloud = cloud;
        this.views = views;
        this.organisations = organisations;
    }

    /** Who waits, longest first. */
    public List<PendingVehicleView> waiting(Principal principal) {
        RoleChecks.requireServer(principal, Role.ADMINISTRATOR);
        return cloud.waiting().stream()
                .map(waiting -> PendingVehicleView.of(waiting, principal))
                .toList();
    }

    /** Makes a drone of it; one that was quarantined becomes a drone of its own. */
    public DroneView enrol(Principal principal, String id, EnrolRequest request) {
        RoleChecks.requireServer(principal, Role.ADMINISTRATOR);
        String name = request.name() == null ? null : NameRules.checked("name", request.name(), LONGEST_NAME);
        OrganisationId owner = organisations.named(request.organisation());
        return cloud.admit(id, name, drone -> organisations.enrolled(drone, owner))
                .map(state -> views.view(state, principal))
                .orElseThrow(() -> Rejection.unknown(NotFoundProblem.WAITING_VEHICLE, id));
    }

    /** Takes it off the list; it comes again when it is heard again. */
    public void dismiss(Principal principal, String id) {
        RoleChecks.requireServer(principal, Role.ADMINISTRATOR);
        if (!cloud.dismiss(id)) {
            throw Rejection.unknown(NotFoundProblem.WAITING_VEHICLE, id);
        }
    }
}
