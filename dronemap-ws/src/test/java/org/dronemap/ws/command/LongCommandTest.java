package org.dronemap.ws.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.VehicleChannel;
import org.dronemap.core.command.Outcome;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.testserver.ConditionWait;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.SharedServer;
import org.dronemap.ws.testserver.TestServer;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Commands that take longer than anybody waits without news. */
class LongCommandTest {
    private static final Principal ANN = new Principal("ann", Role.OPERATOR);

    private final TestServer house = SharedServer.get();
    private final CommandService commands = house.bean(CommandService.class);
    /** Each a silence that is over when the test says how the command stands then. */
    private final LinkedBlockingQueue<CompletableFuture<CommandView>> silences = new LinkedBlockingQueue<>();

    private CommandView given;
    private VehicleChannel.Report report;

    @BeforeEach
    void give() {
        ScriptedVehicle vehicle = ScriptedVehicle.connect(house.cloud(), 20_000 + house.number());
        vehicle.takesItsTime();
        given = commands.submit(ANN, "rest", vehicle.id(), CommandRequests.takePicture());
        report = ConditionWait.until("it is under way", () -> Optional.ofNullable(vehicle.underWay()));
    }

    private CompletableFuture<CommandView> silence(CommandView before) {
        CompletableFuture<CommandView> one = new CompletableFuture<>();
        silences.add(one);
        return one;
    }

    private void isOver(CommandView now) {
        Optional.ofNullable(silences.poll()).orElseThrow().complete(now);
    }

    /** As it stands once so many steps are done. */
    private CommandView done(int steps) {
        report.progress(steps, 30);
        return ConditionWait.until(
                steps + " steps are done",
                () -> Optional.of(commands.command(ANN, given.id()))
                        .filter(now -> now.progress() != null && now.progress().done() == steps));
    }

    private CommandView ended() {
        report.ended(new Outcome.Succeeded());
        return ConditionWait.until(
                "it has ended",
                () -> Optional.of(commands.command(ANN, given.id())).filter(now -> now.outcome() != null));
    }

    @Test
    void areWaitedForAsLongAsThereIsNewsOfThem() {
        CompletableFuture<CommandView> end = CommandService.awaitEndOrSilence(given, this::silence);
        for (int steps = 1; steps <= 25; steps++) {
            isOver(done(steps));
            assertThat(end).isNotDone();
        }

        isOver(ended());

        assertThat(end).isCompletedWithValueMatching(last -> last.outcome() != null);
    }

    @Test
    void areGivenUpWithoutNews() {
        CompletableFuture<CommandView> end = CommandService.awaitEndOrSilence(given, this::silence);
        CommandView news = done(1);
        isOver(news);
        assertThat(end).isNotDone();

        isOver(news);

        assertThat(end).isCompletedWithValueMatching(last -> last.outcome() == null);
    }

    @Test
    void areGivenUpWhenSoMuchTimeHasGoneWithoutNews() {
        CompletableFuture<CommandView> end = commands.awaitEndOrSilence(given, Duration.ofMillis(100));

        assertThat(end)
                .succeedsWithin(10, TimeUnit.SECONDS)
                .satisfies(last -> assertThat(last.outcome()).isNull());
    }
}
