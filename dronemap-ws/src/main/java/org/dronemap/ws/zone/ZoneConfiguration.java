package org.dronemap.ws.zone;

import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.zone.Zone;
import org.dronemap.ws.stream.StreamTopic;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;
import org.springframework.core.annotation.Order;

/** Spring configuration of the handlers and services for zones. */
@Configuration(proxyBeanMethods = false)
@Import({ZoneController.class, ZoneService.class, ZoneService.Stores.class})
class ZoneConfiguration {
    @Bean
    @Order(10)
    StreamTopic<Zone> zoneStreamTopic(CloudManager cloud) {
        return ZoneStreamTopic.of(cloud.zones());
    }
}
