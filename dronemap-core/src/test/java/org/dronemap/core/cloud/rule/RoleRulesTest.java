package org.dronemap.core.cloud.rule;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.EnumSet;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.dronemap.core.access.EffectivePermissions;
import org.dronemap.core.access.KeyScope;
import org.dronemap.core.access.Permission;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.Claim;
import org.dronemap.core.cloud.CloudFixtures;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.DroneLink;
import org.dronemap.core.cloud.LinkSession;
import org.dronemap.core.cloud.lane.Lanes;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.cloud.lane.Watchdog;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.time.RealTime;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class RoleRulesTest {
    private final Lanes lanes = new Lanes(new RealTime(), 1);
    private final StoreWriter journal = new StoreWriter(new RealTime());
    private final CloudManager cloud = new CloudManager(
            lanes,
            Watchdog.DEFAULT,
            new RealTime(),
            new CloudManager.Persistence(
                    new CloudFixtures.InMemoryDroneStore(),
                    new CloudFixtures.InMemoryCommandStore(),
                    new CloudFixtures.InMemoryLeaseStore(),
                    new CloudFixtures.InMemoryParameterOverrideStore(),
                    journal),
            () -> new DroneId("drone"));

    @AfterEach
    void close() {
        lanes.close();
        journal.close();
    }

    @Test
    void letsOperatorsAndAboveGiveEveryCommand() {
        for (Role role : EnumSet.of(Role.OPERATOR, Role.SUPERVISOR, Role.ADMINISTRATOR)) {
            assertThat(allowed(role, true)).containsExactlyInAnyOrder(Capability.values());
        }
    }

    @Test
    void letsReportersAndViewersGiveNone() {
        assertThat(allowed(Role.REPORTER, false)).isEmpty();
        assertThat(allowed(Role.VIEWER, false)).isEmpty();
    }

    @Test
    void letsPlannersChangeWhatADroneCarriesOnlyWhileItIsKnownToBeDisarmed() {
        Set<Capability> planning = EnumSet.of(
                Capability.UPLOAD_MISSION, Capability.CLEAR_MISSION, Capability.FENCE, Capability.RALLY_POINTS);
        assertThat(allowed(Role.PLANNER, null)).isEmpty();
        assertThat(allowed(Role.PLANNER, false)).isEqualTo(planning);
        assertThat(allowed(Role.PLANNER, true)).isEmpty();
    }

    @Test
    void letsKeysOfOperatorsDoOnlyTheOperationsThatTheyAreFor() {
        EnumSet<Capability> planning = EnumSet.of(
                Capability.UPLOAD_MISSION, Capability.CLEAR_MISSION, Capability.FENCE, Capability.RALLY_POINTS);

        assertThat(allowed(byKey(null, Permission.VIEW), false)).isEmpty();
        assertThat(allowed(byKey(null, Permission.PLAN), false)).isEqualTo(planning);
        assertThat(allowed(byKey(null, Permission.PLAN), true)).isEmpty();
        assertThat(allowed(byKey(null, Permission.COMMAND), true)).isEqualTo(EnumSet.complementOf(planning));
        assertThat(allowed(byKey(null, Permission.PLAN, Permission.COMMAND), true))
                .containsExactlyInAnyOrder(Capability.values());
    }

    @Test
    void letsKeysCommandOnlyTheirDrones() {
        assertThat(allowed(byKey(Set.of(new DroneId("drone")), Permission.COMMAND), true))
                .isNotEmpty();
        assertThat(allowed(byKey(Set.of(new DroneId("another")), Permission.COMMAND), true))
                .isEmpty();
    }

    private static Principal byKey(@Nullable Set<DroneId> drones, Permission... permissions) {
        return new Principal(
                "ann",
                Role.OPERATOR,
                new KeyScope(drones, Set.of(permissions)),
                "key",
                EffectivePermissions.EVERYWHERE);
    }

    private Set<Capability> allowed(Role role, @Nullable Boolean armed) {
        return allowed(new Principal("one", role), armed);
    }

    /** What that one may ask of a drone that said whether it is armed, or, by null, has not. */
    private Set<Capability> allowed(Principal principal, @Nullable Boolean armed) {
        LinkSession session = new LinkSession(
                new DroneKey("127.0.0.1", 14_601, 1),
                "udp",
                false,
                "ArduCopter 1",
                new CloudFixtures.RecordingChannel());
        DroneLink link =
                CloudFixtures.bound(cloud.admit(new Claim(session, CloudFixtures.copter(null), null, true, 0)));
        if (armed != null) {
            CompletableFuture<Void> done = new CompletableFuture<>();
            link.lane().execute(() -> {
                link.accept(new DroneEvent.ModeReported("GUIDED", armed));
                done.complete(null);
            });
            assertThat(done).succeedsWithin(5, TimeUnit.SECONDS);
        }
        DroneState drone = cloud.drone(link.id()).orElseThrow();
        EnumSet<Capability> allowed = EnumSet.noneOf(Capability.class);
        for (Capability capability : Capability.values()) {
            if (RoleRules.whyNot(principal, drone, capability).isEmpty()) {
                allowed.add(capability);
            }
        }
        return allowed;
    }
}
