package org.dronemap.core.history;

/** Receives telemetry points and history events to be stored; returns at once. */
interface TelemetrySink {
    void point(TelemetryPoint point);

    void event(HistoryEvent event);
}
