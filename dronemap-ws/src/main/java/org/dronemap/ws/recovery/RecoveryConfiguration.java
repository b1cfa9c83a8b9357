package org.dronemap.ws.recovery;

import org.dronemap.cognitive.operation.recovery.RecoveryState;
import org.dronemap.core.conduct.Operations.Snapshot;
import org.dronemap.ws.stream.StreamTopic;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;
import org.springframework.core.annotation.Order;

/** Spring configuration of the handlers and services for recoveries. */
@Configuration(proxyBeanMethods = false)
@Import({RecoveryController.class, RecoveryService.class, RecoveryService.OperationContext.class})
class RecoveryConfiguration {
    @Bean
    @Order(90)
    StreamTopic<Snapshot<RecoveryState>> recoveryStreamTopic(RecoveryService recoveries) {
        return RecoveryStreamTopic.of(recoveries);
    }
}
