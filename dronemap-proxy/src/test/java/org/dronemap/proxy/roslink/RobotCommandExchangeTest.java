package org.dronemap.proxy.roslink;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.cloud.VehicleChannel;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.proxy.roslink.wire.RobotMessage;
import org.dronemap.proxy.roslink.wire.RobotMessage.Angles;
import org.dronemap.proxy.roslink.wire.RobotMessage.Triple;
import org.dronemap.proxy.roslink.wire.RobotOrder;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** Robots that obey, ignore, half do, or are there already: what a command comes to shows in later reports alone. */
class RobotCommandExchangeTest {
    private static final long SECOND = 1_000_000_000L;
    private static final int DISARMED = 3_004;
    private static final int ARMED = 3_104;
    private static final int FLYING = 4_104;

    private final List<RobotOrder> orders = new ArrayList<>();
    private final List<Outcome> outcomes = new ArrayList<>();
    private final List<DroneEvent> news = new ArrayList<>();
    private final RobotTelemetryTranslator telemetry =
            new RobotTelemetryTranslator(RobotType.QUADROTOR, null, news::add, () -> {});
    private long now = 100 * SECOND;
    private @Nullable RobotCommandExchange errand;

    @Test
    void succeedsWhenALaterReportShowsIt() {
        status(DISARMED);
        begin(new Command.Arm());
        assertThat(orders).containsExactly(new RobotOrder.Arm());

        status(DISARMED);
        assertThat(outcomes).isEmpty();
        later(0.5);
        status(ARMED);

        assertThat(outcomes).containsExactly(new Outcome.Succeeded());
    }

    @Test
    void isUnknownWhenTheRobotReportsNothing() {
        status(DISARMED);
        begin(new Command.Arm());
        later(11);

        assertThat(outcomes).singleElement().isInstanceOf(Outcome.Unknown.class);
    }

    @Test
    void failsWhenTheRobotGoesOnReportingSomethingElse() {
        begin(new Command.SetMode("GUIDED"));
        for (int i = 0; i < 11; i++) {
            later(1);
            status(3_006);
        }
        later(1);

        assertThat(outcomes)
                .containsExactly(new Outcome.Failed("The robot does not report that it did: its mode is RTL."));
    }

    @Test
    void asksAgainOnceASecondUntilItShows() {
        begin(new Command.Disarm(false));
        later(0.5);
        assertThat(orders).hasSize(1);
        later(0.6);
        later(1.1);
        assertThat(orders).hasSize(3).containsOnly(new RobotOrder.Disarm());

        status(DISARMED);
        later(5);
        assertThat(orders).hasSize(3);
        assertThat(outcomes).containsExactly(new Outcome.Succeeded());
    }

    @Test
    void doesNotTakeWhatWasReportedBeforeForAnAnswer() {
        status(3_004);
        begin(new Command.SetMode("GUIDED"));
        later(1);
        motion(0, 0);
        telemetryHears(new RobotMessage.Status(null, 12.0, null, null));
        telemetryHears(new RobotMessage.Heartbeat(3, "x", 2, 0));
        assertThat(outcomes).isEmpty();

        status(3_004);
        assertThat(outcomes).containsExactly(new Outcome.Succeeded());
    }

    @Test
    void doesNotTakeAReportWithoutSenseForAnAnswer() {
        status(3_004);
        begin(new Command.SetMode("GUIDED"));
        later(1);
        status(-5);
        status(99_999);
        assertThat(outcomes).isEmpty();
    }

    @Test
    void changesToGuidedBeforeItTakesOffAndWaitsForTheHeight() {
        status(3_100);
        begin(new Command.TakeOff(10));
        assertThat(orders).containsExactly(new RobotOrder.SetMode(4));

        status(ARMED);
        later(1.1);
        assertThat(orders).last().isEqualTo(new RobotOrder.TakeOff(10));
        status(FLYING);
        motion(5, 1);
        int sent = orders.size();
        later(3);
        assertThat(orders).as("not again in the air").hasSize(sent);
        assertThat(outcomes).isEmpty();
        motion(9.2, 0);

        assertThat(outcomes).containsExactly(new Outcome.Succeeded());
    }

    @Test
    void failsWhenItClimbsOnlyHalfTheWay() {
        status(ARMED);
        begin(new Command.TakeOff(10));
        for (int i = 0; i < 36; i++) {
            later(1);
            status(FLYING);
            motion(5, 0);
        }

        assertThat(outcomes)
                .containsExactly(
                        new Outcome.Failed("The robot does not report that it did: it is 5.0 m high, not 10.0 m."));
    }

    @Test
    void isUnknownWhetherADroneWithoutHeightTookOff() {
        status(ARMED);
        begin(new Command.TakeOff(2));
        for (int i = 0; i < 20; i++) {
            later(1);
            status(FLYING);
        }

        assertThat(outcomes).singleElement().isInstanceOf(Outcome.Unknown.class);
    }

    @Test
    void holdsWithZerosUntilItStands() {
        begin(new Command.Hold());
        assertThat(orders).containsExactly(RobotOrder.Twist.STOP);
        later(1.1);
        motion(0, 0.8);
        assertThat(orders).hasSize(2);
        assertThat(outcomes).isEmpty();
        motion(0, 0.01);

        assertThat(outcomes).containsExactly(new Outcome.Succeeded());
    }

    private void begin(Command command) {
        errand = new RobotCommandExchange(
                RobotGoal.of(command).orElseThrow(), telemetry.facts(), orders::add, new Kept(), now);
    }

    private void later(double seconds) {
        now += (long) (seconds * SECOND);
        if (errand != null) {
            errand.advance(telemetry.facts(), now);
        }
    }

    private void status(int state) {
        telemetryHears(new RobotMessage.Status(state, null, null, null));
    }

    private void motion(double height, double speed) {
        Triple none = new Triple(0.0, 0.0, 0.0);
        telemetryHears(new RobotMessage.Motion(
                new Triple(0.0, 0.0, height), new Triple(speed, 0.0, 0.0), none, new Angles(null, null, null)));
    }

    private void telemetryHears(RobotMessage message) {
        telemetry.received(message);
        if (errand != null) {
            errand.received(message, telemetry.facts(), now);
        }
    }

    private final class Kept implements VehicleChannel.Report {
        @Override
        public void accepted() {}

        @Override
        public void progress(int done, int total) {}

        @Override
        public void ended(Outcome outcome) {
            outcomes.add(outcome);
        }
    }
}
