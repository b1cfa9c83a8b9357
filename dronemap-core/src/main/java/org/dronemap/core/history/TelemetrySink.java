package org.dronemap.core.history;

/** Where points and events go; returns at once. */
interface TelemetrySink {
    void point(TelemetryPoint point);

    void event(HistoryEvent event);
}
