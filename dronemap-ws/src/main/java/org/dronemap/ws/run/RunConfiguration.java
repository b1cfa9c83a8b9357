package org.dronemap.ws.run;

import org.dronemap.core.time.Time;
import org.dronemap.ws.schedule.PeriodicTask;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the handlers and services for mission runs. */
@Configuration(proxyBeanMethods = false)
@Import({RunController.class, RunService.class, RunService.OperationContext.class, RunJournalService.class})
class RunConfiguration {
    @Bean
    PeriodicTask runZoneRounds(RunService.OperationContext context, Time time) {
        return RunZoneSynchronizer.start(context, time);
    }
}
