package org.dronemap.ws.follow;

import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.GrantRegistry;
import org.dronemap.core.conduct.VirtualDrones;
import org.dronemap.core.time.Time;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the handlers and services for follows. */
@Configuration(proxyBeanMethods = false)
@Import({FollowController.class, FollowService.class, FollowService.OperationContext.class})
class FollowConfiguration {
    @Bean
    FollowService.Warehouse followWarehouse(VirtualDrones virtuals) {
        return virtuals::warehouse;
    }

    @Bean
    FollowReliefScheduler followReliefs(
            FollowService.OperationContext context,
            FollowService.Warehouse warehouse,
            AccessStore users,
            GrantRegistry grants,
            Time time) {
        FollowReliefScheduler reliefs =
                new FollowReliefScheduler(context, warehouse, new OwnerRightsCache(users, grants, time), time);
        reliefs.start();
        return reliefs;
    }
}
