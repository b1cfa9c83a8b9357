package org.dronemap.sim.load;

import java.util.Locale;
import org.HdrHistogram.Histogram;

/** Load test: percentiles of measured latencies, as JSON in microseconds. Not thread-safe. */
final class LatencyPercentiles {
    private static final long LONGEST_MICROS = 120_000_000;
    private static final double[] PERCENTILES = {0, 10, 25, 50, 75, 90, 95, 99, 99.9, 99.99, 100};

    private final Histogram micros = new Histogram(LONGEST_MICROS, 3);

    void add(long nanos) {
        micros.recordValue(Math.min(LONGEST_MICROS, Math.max(0, nanos / 1_000)));
    }

    long count() {
        return micros.getTotalCount();
    }

    String json() {
        StringBuilder text = new StringBuilder("{\"count\":").append(micros.getTotalCount());
        text.append(String.format(Locale.ROOT, ",\"mean\":%.1f,\"percentiles\":{", micros.getMean()));
        for (int i = 0; i < PERCENTILES.length; i++) {
            text.append(i == 0 ? "" : ",")
                    .append('"')
                    .append(PERCENTILES[i])
                    .append("\":")
                    .append(micros.getValueAtPercentile(PERCENTILES[i]));
        }
        return text.append("}}").toString();
    }
}
