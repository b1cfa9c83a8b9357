package org.dronemap.ws.recording;

import org.dronemap.core.access.GrantRegistry;
import org.dronemap.core.cloud.CloudManager;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the handlers and services for recordings and replays. */
@Configuration(proxyBeanMethods = false)
@Import({
    RecordingController.class,
    ReplayController.class,
    RecordingService.class,
    ReplayService.class,
    TlogExporter.class
})
class RecordingConfiguration {
    @Bean
    ReplayOwners replayOwners(GrantRegistry grants, CloudManager cloud) {
        return ReplayOwners.of(grants, cloud);
    }
}
