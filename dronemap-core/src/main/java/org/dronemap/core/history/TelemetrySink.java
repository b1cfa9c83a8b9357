package org.dronemap.core.history;

/** Receives telemetry points and events; returns at once. */
interface TelemetrySink {
    void point(TelemetryPoint point);

    void event(HistoryEvent event);
}
