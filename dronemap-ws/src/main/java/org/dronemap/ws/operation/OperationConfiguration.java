package org.dronemap.ws.operation;

import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.GrantRegistry;
import org.dronemap.core.conduct.VirtualDrones;
import org.dronemap.core.time.Time;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;

/** Spring configuration of what all kinds of operations have in common. */
@Configuration(proxyBeanMethods = false)
class OperationConfiguration {
    @Bean
    DronePool dronePool(VirtualDrones virtuals) {
        return virtuals::warehouse;
    }

    @Bean
    OwnerRightsCache operationOwners(AccessStore users, GrantRegistry grants, Time time) {
        return new OwnerRightsCache(users, grants, time);
    }
}
