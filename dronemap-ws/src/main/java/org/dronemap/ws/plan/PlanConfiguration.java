package org.dronemap.ws.plan;

import org.dronemap.core.conduct.TakeOffClearance;
import org.dronemap.core.separation.Separation;
import org.dronemap.core.time.Time;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the handlers and services for plans of several drones. */
@Configuration(proxyBeanMethods = false)
@Import({PlanController.class, TourController.class, PlanService.class, PoolPlanDrones.class, TourService.class})
class PlanConfiguration {
    @Bean
    PlanJobExecutor planJobExecutor(Time time) {
        return new PlanJobExecutor(PlanJobExecutor.Limits.of(time.parallelism()), time);
    }

    @Bean
    PlanService.SeparationContext planSeparation(Separation least, TakeOffClearance clearance) {
        return new PlanService.SeparationContext(least, clearance);
    }
}
