package org.dronemap.ws.organisation;

import org.dronemap.core.time.Time;
import org.dronemap.ws.schedule.PeriodicTask;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the handlers and services for organisations, groups, grants and transfers of drones. */
@Configuration(proxyBeanMethods = false)
@Import({
    OrganisationController.class,
    GroupController.class,
    GrantController.class,
    GrantChanges.class,
    OrganisationService.class,
    GiftService.class,
    GroupService.class,
    GrantService.class
})
class OrganisationConfiguration {
    @Bean
    PeriodicTask grantRounds(GrantChanges grants, Time time) {
        return grants.announceRegularly(time);
    }
}
