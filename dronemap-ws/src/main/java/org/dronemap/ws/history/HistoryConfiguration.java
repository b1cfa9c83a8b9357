package org.dronemap.ws.history;

import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.history.HistoryRecorder;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.core.time.Time;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.security.CallerAuthenticator;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the handlers and services for flights, telemetry and events. */
@Configuration(proxyBeanMethods = false)
@Import({
    FlightController.class,
    TelemetryController.class,
    EventController.class,
    FlightService.class,
    TelemetryService.class,
    TelemetryExporter.class,
    EventFollowService.class,
    HistoryStatusService.class
})
class HistoryConfiguration {
    @Bean
    EventWaiters eventWaiters(
            HistoryRecorder history, TelemetryStore store, CallerAuthenticator authentication, Time time) {
        EventWaiters waiters = new EventWaiters(
                store,
                follow -> {
                    Principal now = authentication
                            .still(follow.caller())
                            .orElseThrow(Rejection::sessionEnded)
                            .principal();
                    RoleChecks.require(now, Role.VIEWER);
                    return now;
                },
                time);
        history.onEventsStored(waiters::wake);
        return waiters;
    }
}
