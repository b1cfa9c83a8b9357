package org.dronemap.ws.virtual;

import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the handlers and services for virtual drones. */
@Configuration(proxyBeanMethods = false)
@Import({
    VirtualDroneController.class,
    WarehouseController.class,
    VirtualDroneService.class,
    VirtualDroneViewMapper.class,
    WarehouseService.class
})
class VirtualDroneConfiguration {}
