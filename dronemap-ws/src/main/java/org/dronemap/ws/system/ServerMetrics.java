package org.dronemap.ws.system;

import io.prometheus.metrics.model.snapshots.CounterSnapshot;
import io.prometheus.metrics.model.snapshots.GaugeSnapshot;
import io.prometheus.metrics.model.snapshots.Labels;
import io.prometheus.metrics.model.snapshots.MetricSnapshot;
import io.prometheus.metrics.model.snapshots.MetricSnapshots;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import org.dronemap.core.access.Principal;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.history.HistoryHealth;
import org.dronemap.ws.budget.WorkKind;
import org.dronemap.ws.link.EndpointView;
import org.dronemap.ws.link.LinkTrafficView;
import org.dronemap.ws.link.VehicleEndpointGateway;
import org.dronemap.ws.outlet.OutletMetrics;
import org.dronemap.ws.outlet.OutletView;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/** Metrics of the server, gathered when a monitoring system asks. Any thread. */
public final class ServerMetrics {
    private final CloudManager cloud;
    private final VehicleEndpointGateway links;
    private final Supplier<Refusals> refusals;
    private final Supplier<HistoryHealth> history;
    private final Supplier<OutletView> outlet;

    /**
     * Counts of refused work and of refused or disconnected clients since the start.
     *
     * @param work of each kind, beyond a user's budget
     * @param clients by why they were cut or turned away
     */
    public record Refusals(Map<WorkKind, Long> work, Map<String, Long> clients) {}

    public ServerMetrics(
            CloudManager cloud,
            VehicleEndpointGateway links,
            Supplier<Refusals> refusals,
            Supplier<HistoryHealth> history,
            Supplier<OutletView> outlet) {
        this.refusals = refusals;
        this.history = history;
        this.outlet = outlet;
        this.cloud = cloud;
        this.links = links;
    }

    /** Of drones only what the asker sees. */
    public MetricSnapshots now(Principal principal) {
        List<MetricSnapshot> all = new ArrayList<>();
        all.add(drones(principal));
        endpoints(all);
        vehicles(all, principal);
        process(all);
        refused(all);
        remembered(all);
        all.addAll(OutletMetrics.of(outlet.get()));
        return new MetricSnapshots(all);
    }

    private MetricSnapshot drones(Principal principal) {
        GaugeSnapshot.Builder gauge =
                GaugeSnapshot.builder().name("dronemap_drones").help("Drones by the state of their link.");
        for (LinkState state : LinkState.values()) {
            long count = cloud.drones().stream()
                    .filter(drone -> drone.link().state() == state && principal.sees(drone.id()))
                    .count();
            gauge.dataPoint(point((double) count, Labels.of("state", WireNames.camel(state))));
        }
        return gauge.build();
    }

    private void endpoints(List<MetricSnapshot> all) {
        List<VehicleEndpointGateway.Status> now = links.all();
        all.add(endpointGauge(
                "up", "1 while it is open.", now, status -> status.state().equals("open") ? 1 : 0));
        all.add(endpointGauge(
                "peers", "Addresses heard.", now, status -> status.counts().peers()));
        all.add(endpointGauge(
                "queue",
                "Frames that wait to be sent.",
                now,
                status -> status.counts().queue()));
        all.add(endpointCounter("frames_in", "Good frames received.", now, counts -> counts.framesIn()));
        all.add(endpointCounter("frames_out", "Frames sent.", now, counts -> counts.framesOut()));
        all.add(endpointGauge(
                "frames_lost",
                "Frames missing from sequence numbers; one that comes late is taken off again.",
                now,
                status -> status.counts().lost()));
        all.add(endpointCounter("broken_bytes", "Bytes that belong to no frame.", now, counts -> counts.brokenBytes()));
        all.add(endpointCounter("dropped_in", "Frames that found no room inside.", now, counts -> counts.droppedIn()));
        all.add(endpointCounter(
                "dropped_out", "Frames that the link did not take.", now, counts -> counts.droppedOut()));
        all.add(endpointCounter(
                "throttled", "Deliveries of peers that made too much work.", now, counts -> counts.throttled()));
        all.add(endpointCounter(
                "refused_peers", "Deliveries of addresses beyond the bound.", now, counts -> counts.refusedPeers()));
        all.add(endpointCounter(
                "kernel_drops",
                "Datagrams thrown away by the system, where it tells.",
                now.stream()
                        .filter(status -> status.counts().kernelDrops() != null)
                        .toList(),
                ServerMetrics::kernelDrops));
    }

    private static double kernelDrops(EndpointView.Counts counts) {
        Long drops = counts.kernelDrops();
        return drops == null ? 0 : drops.doubleValue();
    }

    private void vehicles(List<MetricSnapshot> all, Principal principal) {
        List<LinkTrafficView> now = links.traffic().stream()
                .filter(traffic -> isSeen(traffic.drone(), principal))
                .toList();
        all.add(vehicleCounter("received", "Messages received.", now, LinkTrafficView::received));
        all.add(vehicleCounter("sent", "Messages sent.", now, LinkTrafficView::sent));
        all.add(vehicleCounter("doubled", "Copies of messages.", now, LinkTrafficView::doubled));
        all.add(vehicleCounter("dropped", "Messages that found no room inside.", now, LinkTrafficView::dropped));
        all.add(vehicleGauge("lost", "Messages missing from sequence numbers.", now, LinkTrafficView::lost));
        all.add(vehicleGauge("queue", "Messages that wait inside.", now, LinkTrafficView::queue));
    }

    /** What has not become a drone yet is the server's. */
    private static boolean isSeen(@Nullable String drone, Principal principal) {
        return drone == null || principal.sees(new DroneId(drone));
    }

    private void refused(List<MetricSnapshot> all) {
        Refusals now = refusals.get();
        CounterSnapshot.Builder work =
                CounterSnapshot.builder().name("dronemap_refused_work").help("Work beyond a user's budget.");
        now.work().forEach((kind, times) -> work.dataPoint(count(times, Labels.of("work", WireNames.camel(kind)))));
        CounterSnapshot.Builder clients =
                CounterSnapshot.builder().name("dronemap_clients_cut").help("Clients cut or turned away.");
        now.clients().forEach((why, times) -> clients.dataPoint(count(times, Labels.of("why", why))));
        CounterSnapshot.Builder messages = CounterSnapshot.builder()
                .name("dronemap_robot_refused")
                .help("Messages of robots that were not taken.");
        links.refusedMessages().forEach((why, times) -> messages.dataPoint(count(times, Labels.of("why", why))));
        all.add(work.build());
        all.add(clients.build());
        all.add(messages.build());
    }

    private void remembered(List<MetricSnapshot> all) {
        HistoryHealth now = history.get();
        all.add(GaugeSnapshot.builder()
                .name("dronemap_telemetry_up")
                .help("1 while all telemetry is written down as it comes.")
                .dataPoint(point(now.isUp() ? 1 : 0, Labels.EMPTY))
                .build());
        all.add(GaugeSnapshot.builder()
                .name("dronemap_telemetry_waiting")
                .help("Points and events that are not written yet.")
                .dataPoint(point(now.waiting(), Labels.EMPTY))
                .build());
        all.add(CounterSnapshot.builder()
                .name("dronemap_telemetry_written")
                .help("Points and events written.")
                .dataPoint(count((double) now.written(), Labels.EMPTY))
                .build());
        all.add(CounterSnapshot.builder()
                .name("dronemap_telemetry_dropped")
                .help("Points and events that found no room.")
                .dataPoint(count((double) now.dropped(), Labels.EMPTY))
                .build());
    }

    private static void process(List<MetricSnapshot> all) {
        all.add(GaugeSnapshot.builder()
                .name("jvm_memory_heap_used_bytes")
                .help("Heap in use.")
                .dataPoint(point(
                        (double) ManagementFactory.getMemoryMXBean()
                                .getHeapMemoryUsage()
                                .getUsed(),
                        Labels.EMPTY))
                .build());
        all.add(GaugeSnapshot.builder()
                .name("jvm_threads")
                .help("Threads alive.")
                .dataPoint(point(ManagementFactory.getThreadMXBean().getThreadCount(), Labels.EMPTY))
                .build());
        all.add(GaugeSnapshot.builder()
                .name("process_uptime_seconds")
                .help("Time since the start.")
                .dataPoint(point(ManagementFactory.getRuntimeMXBean().getUptime() / 1000.0, Labels.EMPTY))
                .build());
    }

    private static MetricSnapshot endpointGauge(
            String name,
            String help,
            List<VehicleEndpointGateway.Status> all,
            ToDoubleFunction<VehicleEndpointGateway.Status> value) {
        GaugeSnapshot.Builder gauge =
                GaugeSnapshot.builder().name("dronemap_endpoint_" + name).help(help);
        all.forEach(status -> gauge.dataPoint(point(value.applyAsDouble(status), endpointLabels(status))));
        return gauge.build();
    }

    private static MetricSnapshot endpointCounter(
            String name,
            String help,
            List<VehicleEndpointGateway.Status> all,
            ToDoubleFunction<EndpointView.Counts> value) {
        CounterSnapshot.Builder counter =
                CounterSnapshot.builder().name("dronemap_endpoint_" + name).help(help);
        all.forEach(status -> counter.dataPoint(count(value.applyAsDouble(status.counts()), endpointLabels(status))));
        return counter.build();
    }

    private static Labels endpointLabels(VehicleEndpointGateway.Status status) {
        return Labels.of("endpoint", status.id(), "url", status.url());
    }

    private static MetricSnapshot vehicleCounter(
            String name, String help, List<LinkTrafficView> all, ToDoubleFunction<LinkTrafficView> value) {
        CounterSnapshot.Builder counter =
                CounterSnapshot.builder().name("dronemap_vehicle_" + name).help(help);
        all.forEach(traffic -> counter.dataPoint(count(value.applyAsDouble(traffic), vehicleLabels(traffic))));
        return counter.build();
    }

    private static MetricSnapshot vehicleGauge(
            String name, String help, List<LinkTrafficView> all, ToDoubleFunction<LinkTrafficView> value) {
        GaugeSnapshot.Builder gauge =
                GaugeSnapshot.builder().name("dronemap_vehicle_" + name).help(help);
        all.forEach(traffic -> gauge.dataPoint(point(value.applyAsDouble(traffic), vehicleLabels(traffic))));
        return gauge.build();
    }

    private static Labels vehicleLabels(LinkTrafficView traffic) {
        String drone = traffic.drone();
        return Labels.of(
                "drone",
                drone == null ? "" : drone,
                "session",
                traffic.address() + ":" + traffic.port() + ":" + traffic.systemId(),
                "transport",
                traffic.transport());
    }

    private static GaugeSnapshot.GaugeDataPointSnapshot point(double value, Labels labels) {
        return GaugeSnapshot.GaugeDataPointSnapshot.builder()
                .value(value)
                .labels(labels)
                .build();
    }

    private static CounterSnapshot.CounterDataPointSnapshot count(double value, Labels labels) {
        return CounterSnapshot.CounterDataPointSnapshot.builder()
                .value(value)
                .labels(labels)
                .build();
    }
}
