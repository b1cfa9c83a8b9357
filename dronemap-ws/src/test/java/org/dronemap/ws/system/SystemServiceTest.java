package org.dronemap.ws.system;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicReference;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.lane.Lanes;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.cloud.lane.Watchdog;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.process.ActivePeers;
import org.dronemap.core.process.PeerCrashGuard;
import org.dronemap.core.process.PeerPattern;
import org.dronemap.core.process.ProcessCrash;
import org.dronemap.core.process.ProcessStart;
import org.dronemap.core.process.SafeMode;
import org.dronemap.core.time.SteppedTime;
import org.dronemap.store.memory.MemoryCommandStore;
import org.dronemap.store.memory.MemoryDroneStore;
import org.dronemap.store.memory.MemoryLeaseStore;
import org.dronemap.store.memory.MemoryParameterOverrideStore;
import org.dronemap.ws.problem.Rejection;
import org.junit.jupiter.api.Test;

class SystemServiceTest {
    private static final Principal ADMINISTRATOR = new Principal("ann", Role.ADMINISTRATOR);
    private static final PeerPattern BAD = PeerPattern.at("10.0.0.7", 14550);

    private final AtomicReference<String> down = new AtomicReference<>("");
    private final SteppedTime time = new SteppedTime(Instant.EPOCH);
    private final CloudManager cloud = new CloudManager(
            new Lanes(time, 1),
            Watchdog.DEFAULT,
            time,
            new CloudManager.Persistence(
                    new MemoryDroneStore(),
                    new MemoryCommandStore(),
                    new MemoryLeaseStore(),
                    new MemoryParameterOverrideStore(),
                    new StoreWriter(time)),
            () -> new DroneId("drone-1"));

    private SystemService service(ProcessStart beginning) {
        List<ServerPart> parts = new ArrayList<>();
        for (String name : List.of("lane-0", "conductor", "journal", "endpoints")) {
            parts.add(new ServerPart(
                    name, () -> down.get().equals(name) ? Optional.of("It stands still.") : Optional.empty()));
        }
        return new SystemService(
                cloud,
                new SystemService.Checks(
                        () -> !down.get().equals("database"),
                        () -> !down.get().equals("links"),
                        () -> !down.get().equals("history"),
                        () -> !down.get().equals("runs"),
                        parts),
                beginning,
                new SystemService.SettingsView(1, null, "1", false, null));
    }

    @Test
    void isNeverUpWhenAPartIsNot() {
        SystemService service = service(ProcessStart.ORDINARY);
        assertThat(service.health().status()).isEqualTo("up");
        assertThat(service.health().parts().values()).containsOnly("up");

        for (String part :
                List.of("database", "links", "history", "runs", "lane-0", "conductor", "journal", "endpoints")) {
            down.set(part);
            assertThat(service.health().status()).as(part).isEqualTo("degraded");
        }
        assertThat(service.health().parts()).containsEntry("endpoints", "down").containsEntry("lane-0", "up");
        assertThat(service.details(ADMINISTRATOR).parts())
                .contains(new HealthView.Part("endpoints", "down", "It stands still."));
    }

    @Test
    void aThreadThatIsAtTheSameThingForTooLongIsDown() {
        AtomicReference<Duration> busy = new AtomicReference<>(Duration.ofSeconds(10));
        ServerPart part = ServerPart.thread("journal", Duration.ofSeconds(10), busy::get);
        assertThat(part.trouble().get()).isEmpty();

        busy.set(Duration.ofMillis(10_001));

        assertThat(part.trouble().get()).contains("It has been at the same thing for 10 s.");
    }

    @Test
    void tellsEverybodyThatItWasStartedAnewAndAdministratorsWhy() {
        ProcessCrash end =
                new ProcessCrash(Instant.ofEpochMilli(5), "lane-0", "It ended with ThreadDeath.", List.of(BAD));
        SafeMode careful = new SafeMode(List.of(end, end, end), Set.of(BAD));
        SystemService service = service(new ProcessStart(end, new PeerCrashGuard(ActivePeers.UNKNOWN, careful)));

        HealthView health = service.health();

        assertThat(health.lastEnd()).isEqualTo(new HealthView.LastEnd(5, "lane-0"));
        assertThat(health.setAside()).isTrue();
        assertThat(health.refusedPeers()).isEqualTo(1);
        assertThat(health.toString()).doesNotContain("10.0.0.7");
        assertThat(service.details(ADMINISTRATOR).refused()).containsExactly("10.0.0.7:14550");
        assertThat(service.details(ADMINISTRATOR).ends()).hasSize(3);
        assertThatThrownBy(() -> service.details(new Principal("bob", Role.SUPERVISOR)))
                .isInstanceOf(Rejection.class);
    }
}
