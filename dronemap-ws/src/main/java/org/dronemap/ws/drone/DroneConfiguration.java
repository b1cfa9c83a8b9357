package org.dronemap.ws.drone;

import org.dronemap.core.cloud.CloudManager;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the handlers and services for drones. */
@Configuration(proxyBeanMethods = false)
@Import({
    DroneController.class,
    SensingController.class,
    UnrestoredParameterController.class,
    DroneService.class,
    SensingService.class,
    UnrestoredParameterService.class
})
class DroneConfiguration {
    @Bean
    DroneViewMapper droneViews(DronePlaceNames places, CloudManager cloud) {
        return new DroneViewMapper(places, cloud.controls(), cloud::sensed, cloud::cloudLoss);
    }
}
