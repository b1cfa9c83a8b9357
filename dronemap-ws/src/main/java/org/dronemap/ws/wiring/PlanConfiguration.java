package org.dronemap.ws.wiring;

import org.dronemap.core.time.Time;
import org.dronemap.ws.command.CommandService;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.plan.PlanController;
import org.dronemap.ws.plan.PlanJobExecutor;
import org.dronemap.ws.plan.PlanService;
import org.dronemap.ws.plan.TourController;
import org.dronemap.ws.plan.TourService;
import org.dronemap.ws.server.ServerComponents;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the services and REST handlers for plans of several drones. */
@Configuration(proxyBeanMethods = false)
@Import({PlanController.class, TourController.class})
public class PlanConfiguration {
    @Bean(destroyMethod = "close")
    PlanJobExecutor planJobExecutor(Time time) {
        return new PlanJobExecutor(PlanJobExecutor.Limits.of(time.parallelism()), time);
    }

    @Bean
    PlanService planService(
            ServerComponents house, PlanJobExecutor desk, DroneService drones, CommandService commands, Time time) {
        return new PlanService(desk, drones, commands, house.cloud().zones(), time);
    }

    @Bean(destroyMethod = "close")
    TourService tourService(ServerComponents house, DroneService drones, Time time) {
        return new TourService(drones, house.cloud().zones(), time);
    }
}
