package org.dronemap.ws.system;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.process.PeerPattern;
import org.dronemap.core.process.ProcessCrash;
import org.dronemap.core.process.ProcessStart;
import org.dronemap.ws.access.RoleChecks;
import org.jspecify.annotations.Nullable;

/** Reports the health of the server, and the settings that its web client needs. Any thread. */
public final class SystemService {
    private static final String UP = "up";
    private static final String DOWN = "down";

    private final CloudManager cloud;
    private final Checks checks;
    private final ProcessStart beginning;
    private final SettingsView settings;
    private final long startedNanos = System.nanoTime();

    /**
     * Settings of the server that clients need.
     *
     * @param phonePage where phones learn to trust this server, by plain HTTP; null: nowhere
     */
    @Schema(name = "SettingsView")
    public record SettingsView(
            int streamPort,
            @Nullable String tileAddress,
            String version,
            boolean publicMode,
            @Nullable String phonePage) {}

    /**
     * Health checks of the server's parts.
     *
     * @param database it answers
     * @param links all ways in are open
     * @param history all that drones do is written down as it comes
     * @param runs all that is conducted goes on
     * @param others each with a name of its own
     */
    public record Checks(
            BooleanSupplier database,
            BooleanSupplier links,
            BooleanSupplier history,
            BooleanSupplier runs,
            List<ServerPart> others) {}

    public SystemService(CloudManager cloud, Checks checks, ProcessStart beginning, SettingsView settings) {
        this.cloud = cloud;
        this.checks = checks;
        this.beginning = beginning;
        this.settings = settings;
    }

    public HealthView health() {
        Map<String, String> parts = new LinkedHashMap<>();
        parts().forEach(part -> parts.put(part.name(), part.state()));
        String database = state(checks.database());
        String links = state(checks.links());
        String history = state(checks.history());
        String runs = state(checks.runs());
        boolean up = Stream.concat(Stream.of(database, links, history, runs), parts.values().stream())
                .allMatch(UP::equals);
        return new HealthView(
                up ? UP : "degraded",
                database,
                links,
                history,
                runs,
                parts,
                HealthView.LastEnd.of(beginning.before()),
                beginning.precautions().isActive(),
                beginning.precautions().refused().size(),
                counts(),
                settings.version(),
                (System.nanoTime() - startedNanos) / 1_000_000_000L);
    }

    /** With the reasons, which name peers: for administrators. */
    public HealthView.Details details(Principal asking) {
        RoleChecks.requireServer(asking, Role.ADMINISTRATOR);
        List<ProcessCrash> ends = beginning.precautions().isActive()
                ? beginning.precautions().ends()
                : Stream.ofNullable(beginning.before()).toList();
        return new HealthView.Details(
                parts(),
                ends.stream().map(HealthView.End::of).toList(),
                beginning.precautions().refused().stream()
                        .map(PeerPattern::toString)
                        .sorted()
                        .toList());
    }

    private List<HealthView.Part> parts() {
        return checks.others().stream()
                .map(part -> {
                    String why = part.trouble().get().orElse(null);
                    return new HealthView.Part(part.name(), why == null ? UP : DOWN, why);
                })
                .toList();
    }

    private static String state(BooleanSupplier check) {
        return check.getAsBoolean() ? UP : DOWN;
    }

    private HealthView.DroneCounts counts() {
        List<DroneState> drones =
                cloud.drones().stream().filter(drone -> !drone.replay()).toList();
        return new HealthView.DroneCounts(
                count(drones, LinkState.LIVE),
                count(drones, LinkState.SUSPECT),
                count(drones, LinkState.LOST),
                drones.stream().filter(SystemService::isReady).count(),
                drones.stream()
                        .filter(drone -> Boolean.TRUE.equals(drone.armed()))
                        .count());
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
