package org.dronemap.ws.wiring;

import java.time.Clock;
import org.dronemap.ws.rest.FollowController;
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
        FollowService.Conduct conduct = new FollowService.Conduct(
                house.runs().operations(), house.runs().follows(), house.cloud());
        return new FollowService(conduct, house.virtuals()::warehouse, clock);
    }
}
