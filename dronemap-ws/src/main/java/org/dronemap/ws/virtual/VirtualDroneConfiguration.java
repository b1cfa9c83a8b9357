package org.dronemap.ws.virtual;

import org.dronemap.core.conduct.VirtualDrones;
import org.dronemap.core.virtual.VirtualDrone;
import org.dronemap.ws.stream.StreamTopic;
import org.dronemap.ws.stream.delivery.StreamEventRouter;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;
import org.springframework.core.annotation.Order;

/** Spring configuration of the handlers and services for virtual drones. */
@Configuration(proxyBeanMethods = false)
@Import({
    VirtualDroneController.class,
    WarehouseController.class,
    VirtualDroneService.class,
    VirtualDroneViewMapper.class,
    WarehouseService.class
})
class VirtualDroneConfiguration {
    @Bean
    @Order(20)
    StreamTopic<VirtualDrone> virtualDroneStreamTopic(
            VirtualDrones virtuals, VirtualDroneViewMapper views, StreamEventRouter news) {
        return VirtualDroneStreamTopic.of(virtuals, views, news);
    }
}
