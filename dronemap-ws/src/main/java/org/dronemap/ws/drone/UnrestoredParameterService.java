package org.dronemap.ws.drone;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.List;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.drone.ParameterOverrides;
import org.dronemap.core.parameter.OverriddenParameter;
import org.dronemap.ws.access.RoleChecks;

/**
 * Lists parameters changed by the cloud and not restored on drones that were removed, for administrators. Any thread.
 */
final class UnrestoredParameterService {
    private final CloudManager cloud;

    /** A drone that is not there any more, as it was called, and what its owner had set on it. */
    @Schema(name = "LeftBehindView")
    record UnrestoredDroneView(String id, String name, Instant since, List<DroneView.OutstandingView> outstanding) {}

    UnrestoredParameterService(CloudManager cloud) {
        this.cloud = cloud;
    }

    /** The oldest first. */
    List<UnrestoredDroneView> leftBehind(Principal principal) {
        RoleChecks.requireServer(principal, Role.ADMINISTRATOR);
        return cloud.outstandingOverrides().stream()
                .map(UnrestoredParameterService::view)
                .toList();
    }

    private static UnrestoredDroneView view(ParameterOverrides left) {
        return new UnrestoredDroneView(
                left.drone().value(),
                left.droneName(),
                left.since(),
                left.values().stream()
                        .filter(OverriddenParameter::isToBeWritten)
                        .map(value -> new DroneView.OutstandingView(value.name(), value.owners(), value.ours()))
                        .toList());
    }
}
