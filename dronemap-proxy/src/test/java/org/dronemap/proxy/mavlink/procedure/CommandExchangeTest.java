package org.dronemap.proxy.mavlink.procedure;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.drone.Severity;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandCancel;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.Heartbeat;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CommandExchangeTest {
    private static final int ARM = 400;
    private static final Outcome DONE = new Outcome.Succeeded();

    private final TestWire wire = new TestWire();

    private CommandExchange exchange(MavCommandRequest.CompletionCheck proof) {
        return new CommandExchange(wire.target(), request(proof), ExchangeObserver.NONE);
    }

    private MavCommandRequest request(MavCommandRequest.CompletionCheck proof) {
        return request(MavCommandRequest.Retry.REPEATABLE, proof);
    }

    private MavCommandRequest request(MavCommandRequest.Retry retry, MavCommandRequest.CompletionCheck proof) {
        return MavCommandRequest.ofLong(wire.target(), ARM, new float[] {1f}, retry, proof);
    }

    private static MavCommandRequest.CompletionCheck seen(BooleanSupplier seen) {
        return new MavCommandRequest.CompletionCheck(
                seen, Duration.ofSeconds(5), "It did not arm.", MavCommandRequest.CompletionCheck.ANY);
    }

    private static CommandAck ack(int result) {
        return new CommandAck(ARM, result, 0, 0, 255, 190);
    }

    @Test
    void isSentOnceWhenTheAnswerComes() {
        wire.peer((w, message) -> w.answer(ack(0)));

        assertThat(wire.runWhole(exchange(MavCommandRequest.CompletionCheck.ACKNOWLEDGED)))
                .isEqualTo(DONE);
        assertThat(wire.sent()).hasSize(1);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 5, 8})
    void survivesSoManyLostAnswersWithRisingConfirmation(int lost) {
        wire.peer((w, message) -> {
            if (((CommandLong) message).confirmation() == lost) {
                w.answer(ack(0));
            }
        });

        assertThat(wire.runWhole(exchange(MavCommandRequest.CompletionCheck.ACKNOWLEDGED)))
                .isEqualTo(DONE);
        assertThat(wire.sent(CommandLong.class))
                .extracting(CommandLong::confirmation)
                .hasSize(lost + 1)
                .isSorted();
    }

    @Test
    void endsTimedOutWithinTheStatedTime() {
        long before = wire.now();

        assertThat(wire.runWhole(exchange(MavCommandRequest.CompletionCheck.ACKNOWLEDGED)))
                .isEqualTo(new Outcome.TimedOut("No answer from the vehicle within 8 s (9 tries)."));
        assertThat(wire.sent()).hasSize(9);
        assertThat(wire.now() - before).isLessThan(8_100_000_000L);
    }

    @Test
    void countsWhatIsSeenMoreThanTheAnswer() {
        AtomicBoolean armed = new AtomicBoolean();
        wire.peer((w, message) -> {
            armed.set(true);
            w.answer(new CommandAck(999, 0, 0, 0, 255, 190));
        });

        assertThat(wire.runWhole(exchange(seen(armed::get)))).isEqualTo(DONE);
        assertThat(wire.sent()).hasSize(1);
    }

    @Test
    void takesWhatWasSoBeforeForNoProof() {
        assertThat(wire.runWhole(exchange(seen(() -> true)))).isInstanceOf(Outcome.TimedOut.class);
    }

    @Test
    void failsWhenAcceptedButNeverSeen() {
        wire.peer((w, message) -> w.answer(ack(0)));
        CommandExchange exchange = exchange(seen(() -> false));
        exchange.start(wire.now());
        for (int i = 0; i < 7; i++) {
            wire.run(exchange, 1);
            exchange.received(wire.frame(new CommandAck(999, 0, 0, 0, 255, 190)), wire.now());
        }

        assertThat(exchange.outcome()).isEqualTo(new Outcome.Failed("It did not arm."));
        assertThat(wire.sent()).hasSize(1);
    }

    /** Accepted at once; the vehicle says other things all the time, and after so many seconds how it is. */
    private @Nullable Outcome toldAfter(int seconds, boolean done) {
        AtomicBoolean armed = new AtomicBoolean();
        CommandExchange exchange = exchange(new MavCommandRequest.CompletionCheck(
                armed::get, Duration.ofSeconds(5), "It did not arm.", Heartbeat.ID));
        wire.peer((w, message) -> w.answer(ack(0)));
        exchange.start(wire.now());
        wire.run(exchange, 0.5);
        for (int second = 1; second <= seconds && exchange.outcome() == null; second++) {
            exchange.received(wire.frame(new CommandAck(999, 0, 0, 0, 255, 190)), wire.now());
            wire.run(exchange, 1);
        }
        armed.set(done);
        exchange.received(wire.frame(new Heartbeat(2, 3, 0, 0, 4, 3)), wire.now());
        return wire.run(exchange, 0.5);
    }

    @Test
    void waitsForTheMessageThatWouldShowItWhileOthersFlow() {
        assertThat(toldAfter(7, true)).isEqualTo(DONE);
    }

    @Test
    void failsWhenThatMessageShowsOtherwise() {
        assertThat(toldAfter(7, false)).isEqualTo(new Outcome.Failed("It did not arm."));
    }

    @Test
    void isNotKnownWhereThatMessageStaysAway() {
        assertThat(toldAfter(14, true))
                .isEqualTo(new Outcome.Unknown("The vehicle accepted it, but has not said what it does since."));
    }

    @Test
    void tellsTheSentenceThatFollowsARefusal() {
        wire.peer((w, message) -> w.answer(ack(4)));
        CommandExchange exchange = exchange(MavCommandRequest.CompletionCheck.ACKNOWLEDGED);
        exchange.start(wire.now());
        wire.run(exchange, 0.5);
        exchange.textReceived(Severity.CRITICAL, "PreArm: GPS not ready", wire.now());

        assertThat(wire.run(exchange, 1))
                .isEqualTo(new Outcome.Refused("vehicle", "PreArm: GPS not ready", OutcomeCode.VEHICLE_FAILED));
    }

    @Test
    void tellsTheSentenceThatCameJustBeforeARefusalButNoOlderOne() {
        CommandExchange exchange = exchange(MavCommandRequest.CompletionCheck.ACKNOWLEDGED);
        exchange.start(wire.now());
        exchange.textReceived(Severity.CRITICAL, "an old story", wire.now());
        wire.run(exchange, 0.7);
        exchange.textReceived(Severity.CRITICAL, "Arm: compass not healthy", wire.now());
        exchange.received(wire.frame(ack(4)), wire.now());

        assertThat(wire.run(exchange, 2))
                .isEqualTo(new Outcome.Refused("vehicle", "Arm: compass not healthy", OutcomeCode.VEHICLE_FAILED));
    }

    @Test
    void saysTheResultInWordsWhenTheVehicleSaysNothing() {
        wire.peer((w, message) -> w.answer(ack(2)));

        assertThat(wire.runWhole(exchange(MavCommandRequest.CompletionCheck.ACKNOWLEDGED)))
                .isEqualTo(new Outcome.Refused(
                        "vehicle", "The vehicle denied it and gave no reason.", OutcomeCode.VEHICLE_DENIED));
    }

    @Test
    void waitsAsLongAsTheVehicleSaysThatItIsAtIt() {
        wire.peer((w, message) -> w.answer(ack(5)));
        CommandExchange exchange = exchange(MavCommandRequest.CompletionCheck.ACKNOWLEDGED);
        exchange.start(wire.now());
        for (int second = 0; second < 60; second++) {
            wire.run(exchange, 1);
            exchange.received(wire.frame(ack(5)), wire.now());
        }
        exchange.received(wire.frame(ack(0)), wire.now());

        assertThat(wire.run(exchange, 1)).isEqualTo(DONE);
        assertThat(wire.sent()).hasSize(1);
    }

    @Test
    void asksAgainWhenTheWordThatItIsFinishedWasLost() {
        wire.peer((w, message) -> w.answer(ack(((CommandLong) message).confirmation() == 0 ? 5 : 0)));

        assertThat(wire.runWhole(exchange(MavCommandRequest.CompletionCheck.ACKNOWLEDGED)))
                .isEqualTo(DONE);
        assertThat(wire.sent()).hasSize(2);
    }

    @Test
    void tellsTheVehicleToStopWhenCancelledHalfWay() {
        wire.peer((w, message) -> w.answer(ack(5)));
        CommandExchange exchange = exchange(MavCommandRequest.CompletionCheck.ACKNOWLEDGED);
        exchange.start(wire.now());
        exchange.cancel(wire.now());
        assertThat(wire.sent(CommandCancel.class)).isEmpty();
        wire.run(exchange, 1);
        exchange.cancel(wire.now());

        assertThat(wire.sent(CommandCancel.class)).containsExactly(new CommandCancel(1, 1, ARM));
    }

    @Test
    void sendsAnOnceOnlyCommandOnceAndDoesNotPretendToKnow() {
        wire.peer((w, message) -> w.answer(new CommandAck(999, 0, 0, 0, 255, 190)));
        CommandExchange exchange = new CommandExchange(
                wire.target(),
                request(MavCommandRequest.Retry.ONCE, MavCommandRequest.CompletionCheck.ACKNOWLEDGED),
                ExchangeObserver.NONE);

        assertThat(wire.runWhole(exchange)).isInstanceOf(Outcome.Unknown.class);
        assertThat(wire.sent()).hasSize(1);
    }

    @Test
    void doesNotTakeTheLateEchoOfAnEarlierCommandForItsOwn() {
        MavlinkTarget target = wire.target();
        wire.peer((w, message) -> w.answer(ack(0)));
        MavCommandRequest picture =
                request(MavCommandRequest.Retry.ONCE, MavCommandRequest.CompletionCheck.ACKNOWLEDGED);
        assertThat(wire.runWhole(new CommandExchange(target, picture, ExchangeObserver.NONE)))
                .isEqualTo(DONE);
        // The network doubles the acknowledgement of the first and loses the second command.
        wire.peer((w, message) -> {});
        wire.answer(ack(0));

        assertThat(wire.runWhole(new CommandExchange(target, picture, ExchangeObserver.NONE)))
                .isInstanceOf(Outcome.Unknown.class);
        assertThat(wire.sent()).hasSize(2);
    }

    @Test
    void measuresHowLongAnswersTakeAndAsksAgainSoonerOnAQuickLink() {
        MavlinkTarget target = wire.target();
        wire.peer((w, message) -> w.answer(ack(0)));
        for (int i = 0; i < 8; i++) {
            wire.runWhole(new CommandExchange(
                    target, request(MavCommandRequest.CompletionCheck.ACKNOWLEDGED), ExchangeObserver.NONE));
            wire.run(
                    new CommandExchange(
                            target, request(MavCommandRequest.CompletionCheck.ACKNOWLEDGED), ExchangeObserver.NONE),
                    2);
        }
        assertThat(target.roundTrip().timeoutNanos()).isLessThan(RoundTripEstimator.FIRST_TIMEOUT_NANOS / 2);
        int before = wire.sent().size();
        wire.peer((w, message) -> {});
        CommandExchange unheard = new CommandExchange(
                target, request(MavCommandRequest.CompletionCheck.ACKNOWLEDGED), ExchangeObserver.NONE);
        unheard.start(wire.now());
        wire.run(unheard, 0.5);

        assertThat(wire.sent().size() - before).isEqualTo(2);
    }

    @Test
    void givesASlowLinkItsNineTries() {
        MavlinkTarget target = wire.target();
        for (int i = 0; i < 20; i++) {
            target.roundTrip().measured(i % 2 == 0 ? 700_000_000L : 1_300_000_000L);
        }
        long before = wire.now();

        Outcome outcome = wire.runWhole(new CommandExchange(
                target, request(MavCommandRequest.CompletionCheck.ACKNOWLEDGED), ExchangeObserver.NONE));

        assertThat(wire.sent()).hasSizeGreaterThanOrEqualTo(9);
        assertThat(outcome).isInstanceOf(Outcome.TimedOut.class);
        double took = (wire.now() - before) / 1e9;
        assertThat(((Outcome.TimedOut) outcome).reason())
                .contains(String.format(java.util.Locale.ROOT, "within %.1f s", took));
    }

    @Test
    void believesWhatItSeesMoreThanTheRefusalOfARepetition() {
        AtomicBoolean climbing = new AtomicBoolean();
        wire.peer((w, message) -> {
            boolean first = ((CommandLong) message).confirmation() == 0;
            w.answer(first ? new CommandAck(999, 0, 0, 0, 255, 190) : ack(4));
        });
        CommandExchange takeOff = new CommandExchange(
                wire.target(),
                request(MavCommandRequest.Retry.VERIFY_FIRST, seen(climbing::get)),
                ExchangeObserver.NONE);
        takeOff.start(wire.now());
        for (int i = 0; i < 8; i++) {
            wire.run(takeOff, 0.25);
            takeOff.received(wire.frame(new CommandAck(999, 0, 0, 0, 255, 190)), wire.now());
        }
        assertThat(wire.sent()).hasSize(2);
        climbing.set(true);

        assertThat(wire.run(takeOff, 2)).isEqualTo(DONE);
    }

    @Test
    void doesNotCallFailedWhoFellSilentAfterAccepting() {
        wire.peer((w, message) -> w.answer(ack(0)));

        assertThat(wire.runWhole(exchange(seen(() -> false)))).isInstanceOf(Outcome.Unknown.class);
    }

    @Test
    void ignoresAnswersToSomebodyElse() {
        wire.peer((w, message) -> w.answer(new CommandAck(ARM, 0, 0, 0, 42, 1)));

        assertThat(wire.runWhole(exchange(MavCommandRequest.CompletionCheck.ACKNOWLEDGED)))
                .isInstanceOf(Outcome.TimedOut.class);
    }

    @Test
    void takesADoubledAnswerOnce() {
        wire.peer((w, message) -> {
            w.answer(ack(0));
            w.answer(ack(4));
        });

        assertThat(wire.runWhole(exchange(MavCommandRequest.CompletionCheck.ACKNOWLEDGED)))
                .isEqualTo(DONE);
    }

    @Test
    void doesNotRepeatATakeOffWithoutALookAtTheVehicle() {
        CommandExchange exchange = new CommandExchange(
                wire.target(), request(MavCommandRequest.Retry.VERIFY_FIRST, seen(() -> false)), ExchangeObserver.NONE);

        assertThat(wire.runWhole(exchange)).isInstanceOf(Outcome.TimedOut.class);
        assertThat(wire.sent()).hasSize(1);
    }
}
