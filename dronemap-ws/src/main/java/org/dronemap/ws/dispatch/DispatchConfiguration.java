package org.dronemap.ws.dispatch;

import org.dronemap.cognitive.operation.dispatch.DispatchState;
import org.dronemap.core.conduct.Operations.Snapshot;
import org.dronemap.core.time.Time;
import org.dronemap.ws.operation.DronePool;
import org.dronemap.ws.operation.OperationEnding;
import org.dronemap.ws.operation.OwnerRightsCache;
import org.dronemap.ws.stream.StreamTopic;
import org.dronemap.ws.stream.delivery.StreamEventRouter;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;
import org.springframework.core.annotation.Order;

/** Spring configuration of the handlers and services for dispatches. */
@Configuration(proxyBeanMethods = false)
@Import({DispatchController.class, DispatchService.class, DispatchService.OperationContext.class})
class DispatchConfiguration {
    @Bean
    OperationEnding dispatchEnding(DispatchService dispatches) {
        return dispatches::cancel;
    }

    @Bean
    @Order(70)
    StreamTopic<Snapshot<DispatchState>> dispatchStreamTopic(DispatchService dispatches) {
        return DispatchStreamTopics.changes(dispatches);
    }

    @Bean
    @Order(80)
    StreamTopic<Snapshot<DispatchState>> dispatchNowStreamTopic(DispatchService dispatches, StreamEventRouter news) {
        return DispatchStreamTopics.now(dispatches, news);
    }

    @Bean
    DispatchScheduler dispatchScheduler(
            DispatchService.OperationContext context, DronePool pool, OwnerRightsCache owners, Time time) {
        DispatchScheduler scheduler = new DispatchScheduler(context, pool, owners, time);
        scheduler.start();
        return scheduler;
    }
}
