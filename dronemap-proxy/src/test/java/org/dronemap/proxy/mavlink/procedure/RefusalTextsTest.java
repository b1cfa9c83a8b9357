package org.dronemap.proxy.mavlink.procedure;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.Severity;
import org.dronemap.mavlink.message.CommandAck;
import org.junit.jupiter.api.Test;

/** Which of the texts of a vehicle explain why it refused a command. */
class RefusalTextsTest {
    private static final int SET_MODE = 176;
    private static final int ARM_DISARM = 400;
    private static final int FAILED = 4;
    private static final String NO_REASON = "The vehicle could not do it and gave no reason.";
    private final TestWire wire = new TestWire();

    private CommandExchange refused(int command) {
        wire.peer((w, message) -> w.answer(new CommandAck(command, FAILED, 0, 0, 255, 190)));
        CommandExchange exchange = new CommandExchange(
                wire.target(),
                MavCommandRequest.ofLong(
                        wire.target(),
                        command,
                        new float[] {1f},
                        MavCommandRequest.Retry.REPEATABLE,
                        MavCommandRequest.CompletionCheck.ACKNOWLEDGED),
                ExchangeObserver.NONE);
        exchange.start(wire.now());
        return exchange;
    }

    private void infos(CommandExchange exchange, int count) {
        for (int number = 0; number < count; number++) {
            exchange.textReceived(Severity.INFO, "IMU" + number + " alignment complete", wire.now());
            wire.run(exchange, 0.04);
        }
    }

    private String reason(CommandExchange exchange) {
        Outcome outcome = wire.run(exchange, 10);
        assertThat(outcome).isInstanceOf(Outcome.Refused.class);
        return String.valueOf(outcome.reason());
    }

    @Test
    void tellsTheReasonHoweverManyTextsFollow() {
        CommandExchange exchange = refused(ARM_DISARM);
        exchange.textReceived(Severity.CRITICAL, "Arm: Compass 2 is missing", wire.now());
        infos(exchange, 12);

        assertThat(reason(exchange)).isEqualTo("Arm: Compass 2 is missing");
    }

    @Test
    void waitsForTheReasonBehindManyTexts() {
        CommandExchange exchange = refused(ARM_DISARM);
        infos(exchange, 40);
        exchange.textReceived(Severity.CRITICAL, "PreArm: Logging not started", wire.now());

        assertThat(reason(exchange)).isEqualTo("PreArm: Logging not started");
    }

    @Test
    void callsNothingAReasonThatIsNone() {
        CommandExchange exchange = refused(ARM_DISARM);
        infos(exchange, 5);

        assertThat(reason(exchange)).isEqualTo(NO_REASON);
    }

    @Test
    void tellsAllReasonsOnceAndNoneOfWhatElseWasGrave() {
        CommandExchange exchange = refused(ARM_DISARM);
        exchange.textReceived(Severity.CRITICAL, "PreArm: Fence radius too small", wire.now());
        for (int number = 0; number < 9; number++) {
            exchange.textReceived(Severity.CRITICAL, "Glitch " + number, wire.now());
        }
        exchange.textReceived(Severity.CRITICAL, "Arm: Throttle too high", wire.now());
        exchange.textReceived(Severity.CRITICAL, "Arm: Throttle too high", wire.now());

        assertThat(reason(exchange)).isEqualTo("PreArm: Fence radius too small; Arm: Throttle too high");
    }

    @Test
    void doesNotExplainAModeByWhatKeepsItFromArming() {
        CommandExchange exchange = refused(SET_MODE);
        exchange.textReceived(Severity.NOTICE, "Mode change to CRUISE denied, in recovery", wire.now());
        exchange.textReceived(Severity.CRITICAL, "PreArm: Battery 1 below minimum", wire.now());

        assertThat(reason(exchange)).isEqualTo("Mode change to CRUISE denied, in recovery");
    }

    @Test
    void takesAnInfoThatSaysNoForAReason() {
        CommandExchange exchange = refused(SET_MODE);
        exchange.textReceived(Severity.INFO, "Takeover rejected", wire.now());

        assertThat(reason(exchange)).isEqualTo("Takeover rejected");
    }
}
