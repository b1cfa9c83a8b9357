package org.dronemap.ws.wiring;

import java.util.EnumMap;
import java.util.Map;
import java.util.concurrent.atomic.AtomicReference;
import org.dronemap.proxy.endpoint.WebSocketDoor;
import org.dronemap.ws.budget.Budgets;
import org.dronemap.ws.budget.Work;
import org.dronemap.ws.guard.CrowdFilter;
import org.dronemap.ws.guard.PatientProtocol;
import org.dronemap.ws.stream.StreamCrowd;
import org.dronemap.ws.system.ServerMetrics;

/** Counts of what the protections against clients have refused. Any thread. */
final class Protections {
    private final Budgets budgets;
    private final CrowdFilter crowd;
    private final WebSocketDoor streamDoor;
    private final StreamCrowd streamCrowd;
    /** Null until the web server has made it. */
    private final AtomicReference<PatientProtocol> web = new AtomicReference<>();

    Protections(Budgets budgets, CrowdFilter crowd, WebSocketDoor streamDoor, StreamCrowd streamCrowd) {
        this.budgets = budgets;
        this.crowd = crowd;
        this.streamDoor = streamDoor;
        this.streamCrowd = streamCrowd;
    }

    void web(PatientProtocol protocol) {
        web.set(protocol);
    }

    ServerMetrics.Refusals refusals() {
        Map<Work, Long> work = new EnumMap<>(Work.class);
        for (Work kind : Work.values()) {
            work.put(kind, budgets.refusedCount(kind));
        }
        PatientProtocol protocol = web.get();
        return new ServerMetrics.Refusals(
                work,
                Map.of(
                        "slowHead",
                        protocol == null ? 0 : protocol.cutCount(),
                        "connections",
                        protocol == null ? 0 : protocol.turnedAwayCount(),
                        "requests",
                        crowd.refusedCount(),
                        "stream",
                        streamDoor.refusedCount(),
                        "streams",
                        streamCrowd.turnedAwayCount()));
    }
}
