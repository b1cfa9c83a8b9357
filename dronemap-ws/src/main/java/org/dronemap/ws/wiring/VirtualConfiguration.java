package org.dronemap.ws.wiring;

import org.dronemap.core.time.Time;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.server.ServerComponents;
import org.dronemap.ws.virtual.VirtualDroneController;
import org.dronemap.ws.virtual.VirtualDroneService;
import org.dronemap.ws.virtual.VirtualDroneViewMapper;
import org.dronemap.ws.virtual.WarehouseController;
import org.dronemap.ws.virtual.WarehouseService;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the services and REST handlers for virtual drones. */
@Configuration(proxyBeanMethods = false)
@Import({VirtualDroneController.class, WarehouseController.class})
public class VirtualConfiguration {
    @Bean
    VirtualDroneViewMapper virtualDroneViews(ServerComponents house) {
        return new VirtualDroneViewMapper(house.cloud(), house.virtuals());
    }

    @Bean
    VirtualDroneService virtualDroneService(ServerComponents house, VirtualDroneViewMapper views, Time time) {
        return new VirtualDroneService(house.virtuals(), views, time);
    }

    @Bean
    WarehouseService warehouseService(ServerComponents house, DroneService drones) {
        return new WarehouseService(house.virtuals(), drones);
    }
}
