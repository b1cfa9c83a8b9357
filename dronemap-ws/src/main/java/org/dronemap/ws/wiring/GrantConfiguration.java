package org.dronemap.ws.wiring;

import java.time.Clock;
import java.time.Duration;
import org.dronemap.core.access.GrantBook;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.organisation.GiftService;
import org.dronemap.ws.organisation.GrantChanges;
import org.dronemap.ws.organisation.GrantService;
import org.dronemap.ws.organisation.GroupService;
import org.dronemap.ws.organisation.OrganisationService;
import org.dronemap.ws.recording.ReplayOwners;
import org.dronemap.ws.server.House;
import org.dronemap.ws.server.Rounds;
import org.dronemap.ws.zone.ZoneService;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;

/** Constructs what concerns organisations and grants. */
@Configuration(proxyBeanMethods = false)
public class GrantConfiguration {
    private static final Duration GRANT_RHYTHM = Duration.ofMillis(200);

    @Bean
    GrantChanges grantChanges(House house) {
        house.cloud().zones().ownersBy(house.grantBook()::owner);
        return new GrantChanges(house.grants(), house.grantBook());
    }

    @Bean(destroyMethod = "close")
    Rounds grantRounds(House house) {
        GrantBook book = house.grantBook();
        return new Rounds(
                house.time(),
                "grants",
                GRANT_RHYTHM,
                book::announce,
                "Not everybody could be told that a grant has begun or ended");
    }

    @Bean
    ReplayOwners replayOwners(House house) {
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
    OrganisationService organisationService(House house, GrantChanges grants, ZoneService zones, Clock clock) {
        return new OrganisationService(grants, house.access(), house.cloud(), zones, clock);
    }

    @Bean
    GiftService giftService(
            House house, GrantChanges grants, DroneService drones, OrganisationService organisations, Clock clock) {
        return new GiftService(grants, house.cloud(), house.virtuals(), drones, organisations, house.archive(), clock);
    }

    @Bean
    GroupService groupService(House house, GrantChanges grants, DroneService drones) {
        return new GroupService(grants, house.access(), drones);
    }

    @Bean
    GrantService grantService(House house, GrantChanges grants, GroupService groups, Clock clock) {
        return new GrantService(grants, house.access(), groups, clock);
    }
}
