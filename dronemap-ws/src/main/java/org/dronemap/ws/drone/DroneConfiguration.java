package org.dronemap.ws.drone;

import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.drone.DroneState;
import org.dronemap.ws.stream.StreamTopic;
import org.dronemap.ws.stream.StreamWelcome;
import org.dronemap.ws.stream.delivery.StreamEventRouter;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;
import org.springframework.core.annotation.Order;

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

    @Bean
    @Order(90)
    StreamTopic<DroneState> droneStreamTopic(CloudManager cloud, DroneViewMapper views, StreamEventRouter news) {
        return DroneStreamTopic.of(cloud, views, news);
    }

    @Bean
    StreamWelcome droneStreamWelcome(DroneService drones) {
        return DroneStreamTopic.welcome(drones);
    }
}
