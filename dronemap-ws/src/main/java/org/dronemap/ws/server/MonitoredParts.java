package org.dronemap.ws.server;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.cloud.lane.Lanes;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.conduct.SeparationConductor;
import org.dronemap.core.conduct.VirtualDrones;
import org.dronemap.proxy.endpoint.EndpointRegistry;
import org.dronemap.proxy.roslink.RoslinkConnector;
import org.dronemap.ws.system.ServerPart;

/** Lists the threads and endpoints of the server whose health is monitored, each with a stable name. */
record MonitoredParts(
        Lanes lanes,
        StoreWriter journal,
        VirtualDrones virtuals,
        OperationComponents runs,
        SeparationConductor separation,
        EndpointRegistry vehicles,
        RoslinkConnector robots) {
    /** A lane does nothing that takes long. */
    private static final Duration LONGEST_ON_A_LANE = Duration.ofSeconds(2);
    /** Who writes waits for the database, which answers within five seconds or is told to be down. */
    private static final Duration LONGEST_WRITE = Duration.ofSeconds(10);

    List<ServerPart> all() {
        List<ServerPart> parts = new ArrayList<>();
        lanes.all().forEach(lane -> parts.add(ServerPart.thread(lane.name(), LONGEST_ON_A_LANE, lane::atTheSame)));
        parts.add(ServerPart.thread("conductor", LONGEST_WRITE, virtuals::busyFor));
        parts.add(ServerPart.thread("operations", LONGEST_WRITE, runs.operations()::busyFor));
        ServerPart apart = ServerPart.thread("separation", LONGEST_WRITE, separation::busyFor);
        parts.add(new ServerPart(
                apart.name(),
                () -> separation.trouble().or(() -> apart.trouble().get())));
        parts.add(ServerPart.thread("journal", LONGEST_WRITE, journal::busyFor));
        parts.add(new ServerPart("endpoints", this::endpointTrouble));
        return List.copyOf(parts);
    }

    private Optional<String> endpointTrouble() {
        List<String> broken = new ArrayList<>(vehicles.broken());
        broken.addAll(robots.broken());
        return broken.isEmpty() ? Optional.empty() : Optional.of("No longer open: " + String.join(", ", broken) + ".");
    }
}
