package org.dronemap.ws.history;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.history.TelemetryPoint;
import org.dronemap.core.history.TimeRange;

/** Telemetry points of a span: all of them, or when they are more than is asked for, so many evenly over the time. */
final class EvenPoints {
    private final Instant begin;
    private final int most;
    private final Duration apart;
    private List<TelemetryPoint> chosen = new ArrayList<>();
    /** Before it no further point is chosen. */
    private Instant next;

    private boolean tooMany;

    EvenPoints(TimeRange span, int most) {
        this.begin = span.from();
        this.most = most;
        this.apart = span.length().dividedBy(most);
        this.next = begin;
    }

    /** In the order of time. */
    void add(TelemetryPoint point) {
        if (tooMany) {
            choose(point);
            return;
        }
        chosen.add(point);
        if (chosen.size() > most) {
            tooMany = true;
            List<TelemetryPoint> all = chosen;
            chosen = new ArrayList<>();
            all.forEach(this::choose);
        }
    }

    private void choose(TelemetryPoint point) {
        if (!point.at().isBefore(next)) {
            chosen.add(point);
            next = point.at().plus(apart);
        }
    }

    List<TelemetryPoint> chosen() {
        return List.copyOf(chosen);
    }
}
