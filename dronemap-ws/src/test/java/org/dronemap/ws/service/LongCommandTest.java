package org.dronemap.ws.service;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.VehicleChannel;
import org.dronemap.core.command.Outcome;
import org.dronemap.ws.house.ScriptedVehicle;
import org.dronemap.ws.house.SharedServer;
import org.dronemap.ws.house.TestHouse;
import org.dronemap.ws.house.Waiting;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Commands that take longer than anybody waits without news. */
class LongCommandTest {
    private static final Duration SILENCE = Duration.ofSeconds(1);

    private final TestHouse house = SharedServer.get();
    private CompletableFuture<CommandView> end;
    private VehicleChannel.Report report;

    @BeforeEach
    void give() {
        ScriptedVehicle vehicle = ScriptedVehicle.connect(house.cloud(), 20_000 + house.number());
        vehicle.takesItsTime();
        CommandService commands = house.bean(CommandService.class);
        CommandView given = commands.submit(
                new Principal("ann", Role.OPERATOR), "rest", vehicle.id(), CommandRequest.simple("arm"));
        end = commands.awaitEndOrSilence(given, SILENCE);
        report = Waiting.until("it is under way", () -> Optional.ofNullable(vehicle.underWay()));
    }

    @Test
    void areWaitedForAsLongAsThereIsNewsOfThem() throws InterruptedException {
        for (int done = 1; done <= 25; done++) {
            report.progress(done, 30);
            TimeUnit.MILLISECONDS.sleep(100);
        }
        assertThat(end).isNotDone();
        report.ended(new Outcome.Succeeded());

        assertThat(end)
                .succeedsWithin(5, TimeUnit.SECONDS)
                .satisfies(ended -> assertThat(ended.outcome()).isNotNull());
    }

    @Test
    void areGivenUpWithoutNews() {
        report.progress(1, 30);

        assertThat(end)
                .succeedsWithin(10, TimeUnit.SECONDS)
                .satisfies(ended -> assertThat(ended.outcome()).isNull());
    }
}
