package org.dronemap.ws.wiring;

import org.dronemap.core.time.Time;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.server.House;
import org.dronemap.ws.virtual.VirtualDroneController;
import org.dronemap.ws.virtual.VirtualDroneService;
import org.dronemap.ws.virtual.VirtualDroneViews;
import org.dronemap.ws.virtual.WarehouseController;
import org.dronemap.ws.virtual.WarehouseService;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Constructs the use cases around virtual drones, and their part of the REST face. */
@Configuration(proxyBeanMethods = false)
@Import({VirtualDroneController.class, WarehouseController.class})
public class VirtualConfiguration {
    @Bean
    VirtualDroneViews virtualDroneViews(House house) {
        return new VirtualDroneViews(house.cloud(), house.virtuals());
    }

    @Bean
    VirtualDroneService virtualDroneService(House house, VirtualDroneViews views, Time time) {
        return new VirtualDroneService(house.virtuals(), views, time);
    }

    @Bean
    WarehouseService warehouseService(House house, DroneService drones) {
        return new WarehouseService(house.virtuals(), drones);
    }
}
