package org.dronemap.ws.plan.topic;

import org.dronemap.ws.plan.PlanJob;
import org.dronemap.ws.plan.PlanJobExecutor;
import org.dronemap.ws.stream.StreamTopic;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.core.annotation.Order;

/** Spring configuration of the topic of the stream about plans. */
@Configuration(proxyBeanMethods = false)
class PlanStreamConfiguration {
    @Bean
    @Order(30)
    StreamTopic<PlanJob> planStreamTopic(PlanJobExecutor plans) {
        return PlanStreamTopic.of(plans);
    }
}
