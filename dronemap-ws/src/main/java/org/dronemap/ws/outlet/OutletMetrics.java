package org.dronemap.ws.outlet;

import io.prometheus.metrics.model.snapshots.CounterSnapshot;
import io.prometheus.metrics.model.snapshots.GaugeSnapshot;
import io.prometheus.metrics.model.snapshots.Labels;
import io.prometheus.metrics.model.snapshots.MetricSnapshot;
import java.util.List;

/** Metrics of the outlet for third-party ground stations: attached clients and refused messages. */
public final class OutletMetrics {
    private OutletMetrics() {}

    public static List<MetricSnapshot> of(OutletView now) {
        GaugeSnapshot clients = GaugeSnapshot.builder()
                .name("dronemap_outlet_clients")
                .help("Ground stations and programs that are attached.")
                .dataPoint(GaugeSnapshot.GaugeDataPointSnapshot.builder()
                        .value(now.clients().size())
                        .build())
                .build();
        OutletView.RefusedView refused = now.refused();
        CounterSnapshot outside = CounterSnapshot.builder()
                .name("dronemap_outlet_refused")
                .help("Messages that stayed outside, by why.")
                .dataPoint(count(refused.unsigned(), Labels.of("why", "unsigned")))
                .dataPoint(count(refused.badSignature(), Labels.of("why", "badSignature")))
                .dataPoint(count(refused.replayed(), Labels.of("why", "replayed")))
                .dataPoint(count(refused.tooOld(), Labels.of("why", "tooOld")))
                .dataPoint(count(refused.turnedAway(), Labels.of("why", "turnedAway")))
                .dataPoint(count(refused.elsewhere(), Labels.of("why", "elsewhere")))
                .build();
        return List.of(
                clients,
                outside,
                counter(
                        "dronemap_outlet_not_passed",
                        "Messages of clients of kinds that do not pass.",
                        now.notPassed()),
                counter("dronemap_outlet_dropped", "Messages of vehicles that found no room inside.", now.dropped()));
    }

    private static CounterSnapshot counter(String name, String help, long value) {
        return CounterSnapshot.builder()
                .name(name)
                .help(help)
                .dataPoint(count(value, Labels.EMPTY))
                .build();
    }

    private static CounterSnapshot.CounterDataPointSnapshot count(long value, Labels labels) {
        return CounterSnapshot.CounterDataPointSnapshot.builder()
                .value((double) value)
                .labels(labels)
                .build();
    }
}
