package org.dronemap.ws.system;

import java.util.function.Supplier;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.history.HistoryRecorder;
import org.dronemap.ws.link.VehicleEndpointGateway;
import org.dronemap.ws.outlet.OutletGateway;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the handlers and services for the health, metrics and backups of the server. */
@Configuration(proxyBeanMethods = false)
@Import({
    BackupController.class,
    MetricsController.class,
    SystemController.class,
    BackupService.class,
    SystemService.class
})
class SystemConfiguration {
    @Bean
    ServerMetrics serverMetrics(
            CloudManager cloud,
            VehicleEndpointGateway links,
            Supplier<ServerMetrics.Refusals> refusals,
            HistoryRecorder history,
            OutletGateway outlet) {
        return new ServerMetrics(cloud, links, refusals, history::health, outlet::status);
    }
}
