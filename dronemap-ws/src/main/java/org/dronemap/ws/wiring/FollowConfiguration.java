package org.dronemap.ws.wiring;

import java.time.Clock;
import org.dronemap.core.time.Time;
import org.dronemap.ws.rest.FollowController;
import org.dronemap.ws.service.FollowReliefs;
import org.dronemap.ws.service.FollowService;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Constructs the use cases around follows, and their part of the REST face. */
@Configuration(proxyBeanMethods = false)
@Import(FollowController.class)
public class FollowConfiguration {
    @Bean
    FollowService followService(House house, Clock clock) {
        return new FollowService(conduct(house), house.virtuals()::warehouse, clock);
    }

    @Bean
    FollowReliefs followReliefs(House house, Time time) {
        FollowReliefs reliefs = new FollowReliefs(
                conduct(house),
                house.virtuals()::warehouse,
                new AccountRights(house.access(), house.grantBook(), house.time()),
                time);
        reliefs.start();
        return reliefs;
    }

    private static FollowService.Conduct conduct(House house) {
        return new FollowService.Conduct(house.runs().operations(), house.runs().follows(), house.cloud());
    }
}
