package org.dronemap.ws.wiring;

import org.dronemap.core.time.Time;
import org.dronemap.ws.follow.FollowController;
import org.dronemap.ws.follow.FollowReliefScheduler;
import org.dronemap.ws.follow.FollowService;
import org.dronemap.ws.follow.OwnerRightsCache;
import org.dronemap.ws.server.ServerComponents;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the services and REST handlers for follows. */
@Configuration(proxyBeanMethods = false)
@Import(FollowController.class)
public class FollowConfiguration {
    @Bean
    FollowService followService(ServerComponents house, Time time) {
        return new FollowService(conduct(house), house.virtuals()::warehouse, time);
    }

    @Bean
    FollowReliefScheduler followReliefs(ServerComponents house, Time time) {
        FollowReliefScheduler reliefs = new FollowReliefScheduler(
                conduct(house),
                house.virtuals()::warehouse,
                new OwnerRightsCache(house.access(), house.grantBook(), time),
                time);
        reliefs.start();
        return reliefs;
    }

    private static FollowService.OperationContext conduct(ServerComponents house) {
        return new FollowService.OperationContext(
                house.runs().operations(), house.runs().follows(), house.cloud());
    }
}
