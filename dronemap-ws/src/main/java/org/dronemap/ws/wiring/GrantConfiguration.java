package org.dronemap.ws.wiring;

import java.time.Clock;
import java.time.Duration;
import org.dronemap.core.access.GrantRegistry;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.organisation.GiftService;
import org.dronemap.ws.organisation.GrantChanges;
import org.dronemap.ws.organisation.GrantService;
import org.dronemap.ws.organisation.GroupService;
import org.dronemap.ws.organisation.OrganisationService;
import org.dronemap.ws.recording.ReplayOwners;
import org.dronemap.ws.server.PeriodicTask;
import org.dronemap.ws.server.ServerComponents;
import org.dronemap.ws.zone.ZoneService;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;

/** Spring configuration of the services for organisations, groups, grants and transfers of drones. */
@Configuration(proxyBeanMethods = false)
public class GrantConfiguration {
    private static final Duration GRANT_RHYTHM = Duration.ofMillis(200);

    @Bean
    GrantChanges grantChanges(ServerComponents house) {
        house.cloud().zones().ownersBy(house.grantBook()::owner);
        return new GrantChanges(house.grants(), house.grantBook());
    }

    @Bean(destroyMethod = "close")
    PeriodicTask grantRounds(ServerComponents house) {
        GrantRegistry book = house.grantBook();
        return new PeriodicTask(
                house.time(),
                "grants",
                GRANT_RHYTHM,
                book::announce,
                "Not everybody could be told that a grant has begun or ended");
    }

    @Bean
    ReplayOwners replayOwners(ServerComponents house) {
        ReplayOwners owners = new ReplayOwners(house.grantBook());
        house.cloud().registerBy((drone, session) -> {
            if (session.replay()) {
                // A recording is told from others by the port of its sessions.
                owners.appeared("r" + session.key().port(), drone);
            }
        });
        return owners;
    }

    @Bean
    OrganisationService organisationService(
            ServerComponents house, GrantChanges grants, ZoneService zones, Clock clock) {
        return new OrganisationService(grants, house.access(), house.cloud(), zones, clock);
    }

    @Bean
    GiftService giftService(
            ServerComponents house,
            GrantChanges grants,
            DroneService drones,
            OrganisationService organisations,
            Clock clock) {
        return new GiftService(grants, house.cloud(), house.virtuals(), drones, organisations, house.archive(), clock);
    }

    @Bean
    GroupService groupService(ServerComponents house, GrantChanges grants, DroneService drones) {
        return new GroupService(grants, house.access(), drones);
    }

    @Bean
    GrantService grantService(ServerComponents house, GrantChanges grants, GroupService groups, Clock clock) {
        return new GrantService(grants, house.access(), groups, clock);
    }
}
