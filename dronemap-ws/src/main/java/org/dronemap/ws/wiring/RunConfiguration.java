package org.dronemap.ws.wiring;

import java.time.Duration;
import org.dronemap.core.time.Time;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.plan.PlanService;
import org.dronemap.ws.run.RunController;
import org.dronemap.ws.run.RunJournalService;
import org.dronemap.ws.run.RunService;
import org.dronemap.ws.run.RunZones;
import org.dronemap.ws.server.House;
import org.dronemap.ws.server.Rounds;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Constructs the use cases around mission runs, and their part of the REST face. */
@Configuration(proxyBeanMethods = false)
@Import(RunController.class)
public class RunConfiguration {
    private static final Duration ZONE_RHYTHM = Duration.ofMillis(500);

    @Bean
    RunService runService(House house, PlanService plans, DroneService drones, Time time) {
        RunService.Conduct conduct =
                new RunService.Conduct(house.runs().operations(), house.runs().kind(), house.cloud());
        return new RunService(conduct, plans, drones, time);
    }

    @Bean(destroyMethod = "close")
    Rounds runZoneRounds(House house, Time time) {
        RunZones zones = new RunZones(
                house.runs().operations(), house.runs().kind(), house.cloud().zones(), time.clock());
        return new Rounds(
                time,
                "run-zones",
                ZONE_RHYTHM,
                zones::tell,
                "Not every mission run could be told of the zones; it is tried again");
    }

    @Bean
    RunJournalService runJournalService(House house, RunService runs) {
        return new RunJournalService(
                runs, house.runs().operations(), house.runs().kind());
    }
}
