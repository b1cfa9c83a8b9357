package org.dronemap.ws.follow;

import org.dronemap.cognitive.operation.follow.FollowState;
import org.dronemap.core.conduct.Operations.Snapshot;
import org.dronemap.core.time.Time;
import org.dronemap.ws.operation.DronePool;
import org.dronemap.ws.operation.OperationEnding;
import org.dronemap.ws.operation.OwnerRightsCache;
import org.dronemap.ws.stream.StreamOperation;
import org.dronemap.ws.stream.StreamTopic;
import org.dronemap.ws.stream.delivery.StreamEventRouter;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;
import org.springframework.core.annotation.Order;

/** Spring configuration of the handlers and services for follows. */
@Configuration(proxyBeanMethods = false)
@Import({FollowController.class, FollowService.class, FollowService.OperationContext.class})
class FollowConfiguration {
    @Bean
    OperationEnding followEnding(FollowService follows) {
        return follows::stop;
    }

    @Bean
    PhoneReachability phoneReachability(FollowService follows) {
        return new PhoneReachability(follows::reached);
    }

    @Bean
    @Order(50)
    StreamTopic<Snapshot<FollowState>> followStreamTopic(FollowService follows) {
        return FollowStreamTopics.changes(follows);
    }

    @Bean
    @Order(60)
    StreamTopic<Snapshot<FollowState>> followNowStreamTopic(FollowService follows, StreamEventRouter news) {
        return FollowStreamTopics.now(follows, news);
    }

    @Bean
    @Order(50)
    StreamOperation<PositionsStreamOperation.ReportPositions> positionsStreamOperation(
            FollowService follows, PhoneReachability phones) {
        return PositionsStreamOperation.of(follows, phones);
    }

    @Bean
    FollowReliefScheduler followReliefs(
            FollowService.OperationContext context, DronePool warehouse, OwnerRightsCache owners, Time time) {
        FollowReliefScheduler reliefs = new FollowReliefScheduler(context, warehouse, owners, time);
        reliefs.start();
        return reliefs;
    }
}
