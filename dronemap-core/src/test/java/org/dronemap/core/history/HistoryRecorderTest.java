package org.dronemap.core.history;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicInteger;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandPhase;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.time.RealTime;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What is remembered of what drones show: points, events and flights. */
class HistoryRecorderTest {
    private static final TelemetryWriter.BatchSettings QUICK =
            new TelemetryWriter.BatchSettings(Duration.ofMillis(5), 1_000, 10_000, Duration.ofMillis(5));

    private final FailingTelemetryStore telemetry = new FailingTelemetryStore();
    private final FailingFlightStore flights = new FailingFlightStore();
    private final StateScript drone = new StateScript();
    private final AtomicInteger ids = new AtomicInteger();
    private @Nullable TelemetryWriter writer;
    private @Nullable FlightRegistry log;
    private HistoryRecorder history = started();

    @AfterEach
    void close() {
        Objects.requireNonNull(writer).close();
        Objects.requireNonNull(log).close();
    }

    @Test
    void keepsStatesOfADroneThatFliesOftenAndOfOneThatRestsSeldom() {
        for (int i = 0; i < 200; i++) {
            show(drone.after(0.05).armed(false).north(0, 0));
        }
        for (int i = 0; i < 200; i++) {
            show(drone.after(0.05).armed(true).north(i, 10));
        }

        written();
        assertThat(telemetry.points)
                .filteredOn(point -> Boolean.FALSE.equals(point.armed()))
                .hasSizeBetween(2, 4);
        assertThat(telemetry.points)
                .filteredOn(point -> Boolean.TRUE.equals(point.armed()))
                .hasSizeBetween(48, 54);
    }

    @Test
    void keepsThePlaceThatBelongsToTheMoment() {
        for (int i = 0; i < 20; i++) {
            show(drone.after(0.2).armed(true).north(i, 10));
            // Other news in between, with the place of before.
            show(drone.after(0.01).battery(90));
        }

        written();
        Instant begin = StateScript.START.plusMillis(200);
        assertThat(telemetry.points.stream().skip(1))
                .allSatisfy(point -> assertThat(
                                Duration.between(begin, point.at()).toMillis() % 210)
                        .isZero());
    }

    @Test
    void keepsNothingOfADroneThatIsNotHeard() {
        show(drone.armed(true).north(0, 0));
        show(drone.after(5).link(LinkState.LOST));
        for (int i = 0; i < 50; i++) {
            show(drone.after(10));
        }

        written();
        assertThat(telemetry.points).hasSize(2);
    }

    @Test
    void tellsEachThingThatHappenedOnce() {
        show(drone.mode("STABILIZE").armed(false));
        show(drone.after(1).mode("GUIDED").says(Severity.WARNING, "one"));
        show(drone.after(1).says(Severity.WARNING, "two").says(Severity.CRITICAL, "two"));
        show(drone.after(1).armed(true));
        show(drone.after(1).battery(50));
        show(drone.after(1).armed(false));

        written();
        assertThat(telemetry.events)
                .extracting(event -> event.kind() + " " + event.text())
                .containsExactly(
                        "MODE STABILIZE",
                        "MODE GUIDED",
                        "MESSAGE one",
                        "MESSAGE two",
                        "MESSAGE two",
                        "ARMED Armed.",
                        "DISARMED Disarmed.");
    }

    @Test
    void tellsEveryMessageThoughOnlyTheNewestAreShown() {
        for (int i = 0; i < 100; i++) {
            show(drone.after(1).says(Severity.INFO, "message " + i));
        }

        written();
        assertThat(telemetry.events)
                .hasSize(100)
                .last()
                .extracting(HistoryEvent::text)
                .isEqualTo("message 99");
    }

    @Test
    void tellsACommandWithItsOutcomeAtTheMomentWhenItWasGiven() {
        show(drone.armed(false));
        CommandRecord sent = command("alice", "rest", drone.now());
        history.commandChanged(sent);
        history.commandChanged(sent.ended(
                new Outcome.Refused("vehicle", "PreArm: no", OutcomeCode.VEHICLE_REFUSED),
                drone.now().plusSeconds(3)));

        written();
        assertThat(telemetry.events)
                .containsExactly(new HistoryEvent(
                        StateScript.DRONE,
                        drone.now(),
                        HistoryEvent.Kind.COMMAND,
                        "arm",
                        null,
                        "alice",
                        "command-1",
                        "refused",
                        "PreArm: no"));
    }

    @Test
    void makesAFlightFromArmingToDisarming() {
        show(drone.armed(false).battery(98).north(0, 0));
        CommandRecord sent = command("alice", "page", drone.now());
        history.commandChanged(sent);
        show(drone.after(1).armed(true));
        history.commandChanged(sent.ended(new Outcome.Succeeded(), drone.now()));
        Instant start = drone.now();
        for (int i = 1; i <= 100; i++) {
            show(drone.after(0.5).north(i * 2, Math.min(i, 30)));
        }
        for (int i = 99; i >= 0; i--) {
            show(drone.after(0.5).north(i * 2, Math.min(i, 30)).battery(80));
        }
        show(drone.after(1).armed(false));

        Flight flight = flight(Flight.State.ENDED);
        assertThat(flight.start()).isEqualTo(start);
        assertThat(flight.end()).isEqualTo(start.plusSeconds(101));
        assertThat(flight.users()).containsExactly("alice");
        assertThat(flight.measures().distanceMeters()).isCloseTo(400, within(2.0));
        assertThat(flight.measures().highestMeters()).isEqualTo(30);
        assertThat(flight.measures().farthestMeters()).isCloseTo(200, within(1.0));
        assertThat(flight.measures().batteryUsed()).isEqualTo(18);
        assertThat(flight.notice()).isNull();
    }

    @Test
    void doesNotAddUpTheNoiseOfADroneThatStands() {
        show(drone.armed(true).north(0, 0));
        for (int i = 0; i < 500; i++) {
            show(drone.after(0.2).north(i % 2 == 0 ? 0.4 : -0.4, 0));
        }
        show(drone.after(1).armed(false));

        assertThat(flight(Flight.State.ENDED).measures().distanceMeters()).isLessThan(2);
    }

    @Test
    void namesNobodyForAFlightThatWasBegunByHand() {
        show(drone.armed(false));
        history.commandChanged(command("zones", "safety", drone.now()));
        history.commandChanged(command("bob", "rest", drone.now())
                .ended(new Outcome.Refused("gate", "not now", OutcomeCode.COMMAND_REFUSED), drone.now()));
        show(drone.after(1).armed(true));
        show(drone.after(9).armed(false));

        assertThat(flight(Flight.State.ENDED).users()).isEmpty();
    }

    @Test
    void endsALostFlightWhereItWasLastHeardAndGoesOnWhenItIsHeardAgain() {
        show(drone.armed(true).north(0, 5));
        show(drone.after(10).north(100, 5));
        Instant last = drone.now();
        show(drone.after(5).link(LinkState.LOST));

        assertThat(flight(Flight.State.LOST).end()).isEqualTo(last);

        // The first state after a silence shows what was known before it.
        show(drone.after(60).link(LinkState.LIVE));
        for (int i = 0; i < 10; i++) {
            show(drone.after(1).north(100 + i, 5).armed(true));
        }
        assertThat(flight(Flight.State.RUNNING).notice()).contains("no contact");
        show(drone.after(1).armed(false));
        assertThat(flight(Flight.State.ENDED).end()).isEqualTo(drone.now());
        assertThat(flights.flights).hasSize(1);
    }

    @Test
    void endsALostFlightWhereItWasLastHeardWhenItIsFoundDisarmed() {
        show(drone.armed(true).north(0, 5));
        show(drone.after(10).north(100, 5));
        Instant last = drone.now();
        show(drone.after(5).link(LinkState.LOST));
        show(drone.after(600).link(LinkState.LIVE));
        show(drone.after(1).armed(false));

        Flight flight = flight(Flight.State.ENDED);
        assertThat(flight.end()).isEqualTo(last);
        assertThat(flight.notice()).contains("Disarmed while there was no contact");
    }

    @Test
    void beginsAnotherFlightAfterALongSilence() {
        show(drone.armed(true).north(0, 5));
        show(drone.after(5).link(LinkState.LOST));
        show(drone.after(7_200).link(LinkState.LIVE).armed(true));
        show(drone.after(4).armed(true));

        await().atMost(Duration.ofSeconds(30)).until(() -> flights.flights.size() == 2);
        assertThat(flights.flights.values())
                .extracting(Flight::state)
                .containsExactlyInAnyOrder(Flight.State.LOST, Flight.State.RUNNING);
    }

    @Test
    void goesOnWithAFlightOverARestart() {
        show(drone.armed(true).battery(90).north(0, 5));
        // So soon that the flight itself is not written anew.
        for (int i = 1; i <= 20; i++) {
            show(drone.after(0.25).north(i * 5, 5));
        }
        Instant last = drone.now();
        written();
        flight(Flight.State.RUNNING);

        close();
        drone.after(20).armed(null);
        history = started();
        Flight interrupted = flight(Flight.State.LOST);
        assertThat(interrupted.end()).isEqualTo(last);
        assertThat(interrupted.measures().distanceMeters()).isCloseTo(100, within(1.0));

        show(drone.north(200, 5));
        for (int i = 0; i < 6; i++) {
            show(drone.after(1).armed(true).north(200, 5));
        }
        flight(Flight.State.RUNNING);
        show(drone.after(1).armed(false).battery(70));

        Flight ended = flight(Flight.State.ENDED);
        assertThat(flights.flights).hasSize(1);
        assertThat(ended.measures().distanceMeters()).isCloseTo(200, within(1.0));
        assertThat(ended.measures().batteryUsed()).isEqualTo(20);
    }

    @Test
    void remembersNoRecordingThatPlays() {
        show(drone.replayed().armed(true).north(0, 5).says(Severity.INFO, "once more"));
        show(drone.after(10).armed(false));

        written();
        assertThat(telemetry.points).isEmpty();
        assertThat(telemetry.events).isEmpty();
        assertThat(flights.flights).isEmpty();
    }

    @Test
    void writesAFlightWhenTheStoreIsBack() {
        flights.broken = true;
        show(drone.armed(true));
        await().atMost(Duration.ofSeconds(30)).until(() -> !history.health().isUp());
        assertThat(history.health().trouble()).contains("Flights cannot be written");
        show(drone.after(30).armed(false));

        flights.broken = false;

        flight(Flight.State.ENDED);
        await().atMost(Duration.ofSeconds(30)).until(() -> history.health().isUp());
    }

    private HistoryRecorder started() {
        writer = new TelemetryWriter(telemetry, QUICK, new RealTime());
        log = new FlightRegistry(flights, Duration.ofMillis(5), new RealTime());
        HistoryMaintenance keeper = new HistoryMaintenance(telemetry, Retention.DEFAULT, new RealTime());
        HistoryRecorder made = new HistoryRecorder(
                new HistoryRecorder.Persistence(telemetry, writer, log, keeper),
                HistoryPolicy.DEFAULT,
                drone::now,
                () -> "f" + ids.incrementAndGet());
        writer.start();
        log.start();
        made.start();
        return made;
    }

    private void show(StateScript script) {
        history.droneChanged(script.state());
    }

    private void written() {
        await().atMost(Duration.ofSeconds(30)).until(() -> history.health().waiting() == 0);
    }

    /** The newest one, once it is stored in that state. */
    private Flight flight(Flight.State state) {
        await().atMost(Duration.ofSeconds(30))
                .until(() -> flights.flights.values().stream().anyMatch(one -> one.state() == state));
        List<Flight> found = flights.flights.values().stream()
                .filter(one -> one.state() == state)
                .toList();
        return found.get(0);
    }

    private static CommandRecord command(String by, String face, Instant at) {
        return new CommandRecord(
                new CommandId("command-1"),
                StateScript.DRONE,
                by,
                face,
                "Arm",
                "arm",
                at,
                CommandPhase.SENT,
                null,
                null,
                null,
                null);
    }
}
