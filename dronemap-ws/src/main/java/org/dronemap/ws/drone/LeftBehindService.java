package org.dronemap.ws.drone;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.List;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.drone.OwnersValues;
import org.dronemap.core.parameter.OwnersValue;
import org.dronemap.ws.access.Roles;

/**
 * Lists parameters changed by the cloud and not restored on drones that were removed, for administrators. Any thread.
 */
public final class LeftBehindService {
    private final CloudManager cloud;

    /** A drone that is not there any more, as it was called, and what its owner had set on it. */
    @Schema(name = "LeftBehindView")
    public record LeftBehindView(String id, String name, Instant since, List<DroneView.OutstandingView> outstanding) {}

    public LeftBehindService(CloudManager cloud) {
        this.cloud = cloud;
    }

    /** The oldest first. */
    public List<LeftBehindView> leftBehind(Principal principal) {
        Roles.requireServer(principal, Role.ADMINISTRATOR);
        return cloud.leftBehind().stream().map(LeftBehindService::view).toList();
    }

    private static LeftBehindView view(OwnersValues left) {
        return new LeftBehindView(
                left.drone().value(),
                left.droneName(),
                left.since(),
                left.values().stream()
                        .filter(OwnersValue::isToBeWritten)
                        .map(value -> new DroneView.OutstandingView(value.name(), value.owners(), value.ours()))
                        .toList());
    }
}
