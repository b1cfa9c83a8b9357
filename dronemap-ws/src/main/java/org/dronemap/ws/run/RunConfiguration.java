package org.dronemap.ws.run;

import org.dronemap.cognitive.operation.run.RunState;
import org.dronemap.core.conduct.Operations.Snapshot;
import org.dronemap.core.time.Time;
import org.dronemap.ws.operation.OperationEnding;
import org.dronemap.ws.operation.OwnerRightsCache;
import org.dronemap.ws.plan.PoolPlanDrones;
import org.dronemap.ws.schedule.PeriodicTask;
import org.dronemap.ws.stream.StreamTopic;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;
import org.springframework.core.annotation.Order;

/** Spring configuration of the handlers and services for mission runs. */
@Configuration(proxyBeanMethods = false)
@Import({RunController.class, RunService.class, RunService.OperationContext.class, RunJournalService.class})
class RunConfiguration {
    @Bean
    OperationEnding runEnding(RunService runs) {
        return runs::stop;
    }

    @Bean
    @Order(40)
    StreamTopic<Snapshot<RunState>> runStreamTopic(RunService runs) {
        return RunStreamTopic.of(runs);
    }

    @Bean
    PeriodicTask runZoneRounds(RunService.OperationContext context, Time time) {
        return RunZoneSynchronizer.start(context, time);
    }

    @Bean
    PeriodicTask runPoolRounds(
            RunService.OperationContext context, PoolPlanDrones pool, OwnerRightsCache owners, Time time) {
        return RunPoolScheduler.start(context, pool, owners, time);
    }
}
