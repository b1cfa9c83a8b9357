package org.dronemap.ws.control;

import org.dronemap.ws.stream.StreamOperation;
import org.dronemap.ws.stream.StreamTopic;
import org.dronemap.ws.stream.delivery.StreamEventRouter;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;
import org.springframework.core.annotation.Order;

/** Spring configuration of the handlers and services for control and steering. */
@Configuration(proxyBeanMethods = false)
@Import({ControlController.class, ControlService.class, SteeringService.class})
class ControlConfiguration {
    @Bean
    @Order(80)
    StreamTopic<StreamEventRouter.ControlEvent> controlStreamTopic(StreamEventRouter news) {
        return ControlStreamTopic.of(news);
    }

    @Bean
    @Order(20)
    StreamOperation<StreamControlRequest> controlStreamOperation(ControlService controls) {
        return ControlStreamOperation.of(controls);
    }

    @Bean
    SteeringStreamOperations steeringStreamOperations(SteeringService steering) {
        return new SteeringStreamOperations(steering);
    }

    @Bean
    @Order(30)
    StreamOperation<SteeringStreamOperations.Steer> steerStreamOperation(SteeringStreamOperations steering) {
        return steering.steering();
    }

    @Bean
    @Order(40)
    StreamOperation<SteeringStreamOperations.LetGo> letGoStreamOperation(SteeringStreamOperations steering) {
        return steering.lettingGo();
    }
}
