package org.dronemap.ws.wiring;

import java.util.EnumMap;
import java.util.Map;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import org.dronemap.proxy.endpoint.BoundedWebSocketFactory;
import org.dronemap.ws.budget.Budgets;
import org.dronemap.ws.budget.WorkKind;
import org.dronemap.ws.limit.BoundedHttpProtocol;
import org.dronemap.ws.limit.HostConcurrencyFilter;
import org.dronemap.ws.stream.StreamClientRegistry;
import org.dronemap.ws.system.ServerMetrics;

/** Counts, for the metrics, what rate and connection limits have refused to clients. Any thread. */
final class ProtectionCounters implements Supplier<ServerMetrics.Refusals> {
    private final Budgets budgets;
    private final HostConcurrencyFilter crowd;
    private final BoundedWebSocketFactory streamDoor;
    private final StreamClientRegistry streamCrowd;
    /** Null until the web server has made it. */
    private final AtomicReference<BoundedHttpProtocol> web = new AtomicReference<>();

    ProtectionCounters(
            Budgets budgets,
            HostConcurrencyFilter crowd,
            BoundedWebSocketFactory streamDoor,
            StreamClientRegistry streamCrowd) {
        this.budgets = budgets;
        this.crowd = crowd;
        this.streamDoor = streamDoor;
        this.streamCrowd = streamCrowd;
    }

    void web(BoundedHttpProtocol protocol) {
        web.set(protocol);
    }

    @Override
    public ServerMetrics.Refusals get() {
        Map<WorkKind, Long> work = new EnumMap<>(WorkKind.class);
        for (WorkKind kind : WorkKind.values()) {
            work.put(kind, budgets.refusedCount(kind));
        }
        BoundedHttpProtocol protocol = web.get();
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
