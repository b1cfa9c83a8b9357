package org.dronemap.ws.history;

import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the handlers and services for flights and telemetry. */
@Configuration(proxyBeanMethods = false)
@Import({
    FlightController.class,
    TelemetryController.class,
    FlightService.class,
    TelemetryService.class,
    TelemetryExporter.class,
    HistoryStatusService.class
})
class HistoryConfiguration {}
