package org.dronemap.ws.wiring;

import java.time.Duration;
import org.dronemap.core.time.Time;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.plan.PlanService;
import org.dronemap.ws.run.RunController;
import org.dronemap.ws.run.RunJournalService;
import org.dronemap.ws.run.RunService;
import org.dronemap.ws.run.RunZoneSynchronizer;
import org.dronemap.ws.server.PeriodicTask;
import org.dronemap.ws.server.ServerComponents;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the services and REST handlers for mission runs. */
@Configuration(proxyBeanMethods = false)
@Import(RunController.class)
public class RunConfiguration {
    private static final Duration ZONE_RHYTHM = Duration.ofMillis(500);

    @Bean
    RunService runService(ServerComponents house, PlanService plans, DroneService drones, Time time) {
        RunService.OperationContext conduct = new RunService.OperationContext(
                house.runs().operations(), house.runs().kind(), house.cloud());
        return new RunService(conduct, plans, drones, time);
    }

    @Bean(destroyMethod = "close")
    PeriodicTask runZoneRounds(ServerComponents house, Time time) {
        RunZoneSynchronizer zones = new RunZoneSynchronizer(
                house.runs().operations(), house.runs().kind(), house.cloud().zones(), time.clock());
        return new PeriodicTask(
                time,
                "run-zones",
                ZONE_RHYTHM,
                zones::synchronize,
                "Not every mission run could be told of the zones; it is tried again");
    }

    @Bean
    RunJournalService runJournalService(ServerComponents house, RunService runs) {
        return new RunJournalService(
                runs, house.runs().operations(), house.runs().kind());
    }
}
