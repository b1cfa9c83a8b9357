package org.dronemap.ws.service;

import java.util.List;
import java.util.function.BooleanSupplier;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.Position;
import org.jspecify.annotations.Nullable;

/** What the server says of itself. Any thread. */
public final class SystemService {
    private final CloudManager cloud;
    private final Checks checks;
    private final SettingsView settings;
    private final long startedNanos = System.nanoTime();

    /** How many drones there are of each sort: by link, ready to be armed, armed (in contact or not). */
    public record DroneCounts(long live, long suspect, long lost, long ready, long armed) {}

    /** How the server is. */
    public record HealthView(
            String status,
            String database,
            String links,
            String history,
            String runs,
            DroneCounts drones,
            String version,
            long uptimeSeconds) {}

    /**
     * What clients have to know.
     *
     * @param phonePage where phones learn to trust this server, by plain HTTP; null: nowhere
     */
    public record SettingsView(
            int streamPort,
            @Nullable String tileAddress,
            String version,
            boolean publicMode,
            @Nullable String phonePage) {}

    /**
     * What has to work.
     *
     * @param links all ways in are open
     * @param history all that drones do is written down as it comes
     * @param runs all that is conducted goes on
     */
    public record Checks(
            BooleanSupplier database, BooleanSupplier links, BooleanSupplier history, BooleanSupplier runs) {}

    public SystemService(CloudManager cloud, Checks checks, SettingsView settings) {
        this.cloud = cloud;
        this.checks = checks;
        this.settings = settings;
    }

    public HealthView health() {
        List<DroneState> drones =
                cloud.drones().stream().filter(drone -> !drone.replay()).toList();
        boolean up = checks.database().getAsBoolean();
        boolean listens = checks.links().getAsBoolean();
        boolean remembers = checks.history().getAsBoolean();
        boolean conducts = checks.runs().getAsBoolean();
        return new HealthView(
                up && listens && remembers && conducts ? "up" : "degraded",
                up ? "up" : "down",
                listens ? "up" : "down",
                remembers ? "up" : "down",
                conducts ? "up" : "down",
                new DroneCounts(
                        count(drones, LinkState.LIVE),
                        count(drones, LinkState.SUSPECT),
                        count(drones, LinkState.LOST),
                        drones.stream().filter(SystemService::isReady).count(),
                        drones.stream()
                                .filter(drone -> Boolean.TRUE.equals(drone.armed()))
                                .count()),
                settings.version(),
                (System.nanoTime() - startedNanos) / 1_000_000_000L);
    }

    public SettingsView settings() {
        return settings;
    }

    private static long count(List<DroneState> drones, LinkState state) {
        return drones.stream().filter(drone -> drone.link().state() == state).count();
    }

    /** It can be armed: in contact, knows where it is, and its own checks say nothing against it. */
    private static boolean isReady(DroneState drone) {
        Position position = drone.position();
        return drone.link().state() == LinkState.LIVE
                && !Boolean.TRUE.equals(drone.armed())
                && !Boolean.FALSE.equals(drone.readyToArm())
                && position != null
                && position.point() != null;
    }
}
