package org.dronemap.proxy.roslink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import org.dronemap.core.cloud.VehicleChannel;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.EmergencyStop;
import org.dronemap.core.command.GoToLocal;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.ReadMap;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.proxy.roslink.wire.RobotMessage;
import org.dronemap.proxy.roslink.wire.RobotMessage.Angles;
import org.dronemap.proxy.roslink.wire.RobotMessage.Triple;
import org.dronemap.proxy.roslink.wire.RobotOrder;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** Ground robots sent to a place, stopped at once and asked for their map: obedient ones, such as ignore it, and such as half do. */
class RobotGoalExchangeTest {
    private static final long SECOND = 1_000_000_000L;
    private static final byte[] PNG = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', 1};
    private static final Command THERE = new GoToLocal(3, 4, null);

    private final List<RobotOrder> orders = new ArrayList<>();
    private final List<Outcome> outcomes = new ArrayList<>();
    private final List<DroneEvent> news = new ArrayList<>();
    private int unreadable;
    private final RobotTelemetryTranslator telemetry =
            new RobotTelemetryTranslator(RobotType.TURTLEBOT, null, news::add, () -> unreadable++);
    private long now = 100 * SECOND;
    private @Nullable RobotCommandExchange errand;

    @Test
    void hasArrivedOnlyWhenItStandsThere() {
        at(0, 0, 0);
        begin(THERE);
        assertThat(orders).containsExactly(new RobotOrder.GoTo(3, 4, 0, false));
        later(1);
        at(1, 1, 0.4);
        later(1);
        at(3, 4, 0.4);
        assertThat(outcomes).as("it only passes").isEmpty();
        later(1);
        at(3.1, 4.1, 0);

        assertThat(outcomes).containsExactly(new Outcome.Succeeded());
        assertThat(orders).as("not told again while it drives").hasSize(1);
    }

    @Test
    void hasNotArrivedByWhatItReportedBefore() {
        at(3, 4, 0);
        begin(THERE);
        assertThat(outcomes).isEmpty();
        later(0.2);
        at(3, 4, 0);
        assertThat(outcomes).as("by the report after the order").containsExactly(new Outcome.Succeeded());
    }

    @Test
    void failsWhenItStopsHalfWay() {
        begin(THERE);
        later(1);
        at(1, 1, 0.4);
        for (int second = 0; second < 40; second++) {
            later(1);
            at(1.5, 2, 0);
        }

        assertThat(outcomes)
                .containsExactly(new Outcome.Failed("The robot does not report that it did: it is 2.5 m away."));
        assertThat(orders).hasSizeBetween(3, 6);
    }

    @Test
    void isUnknownWhenItSaysNothingOfWhereItIs() {
        begin(THERE);
        for (int second = 0; second < 40; second++) {
            later(1);
            hears(new RobotMessage.Status(null, null, null, null));
        }
        assertThat(outcomes).singleElement().isInstanceOf(Outcome.Unknown.class);
    }

    @Test
    void stopsWithZerosFirstAndSaysTheWordThatKillsABridgeOnce() {
        at(0, 0, 0.4);
        begin(new EmergencyStop());
        assertThat(orders).containsExactly(RobotOrder.Twist.STOP, new RobotOrder.EmergencyStop());
        for (int second = 0; second < 5; second++) {
            later(1.1);
            at(0, 0, 0.4);
        }
        assertThat(outcomes).isEmpty();
        assertThat(orders.subList(2, orders.size())).isNotEmpty().containsOnly(RobotOrder.Twist.STOP);
        at(0, 0, 0);

        assertThat(outcomes).containsExactly(new Outcome.Succeeded());
    }

    @Test
    void hasItsMapWhenOneCame() {
        begin(new ReadMap());
        assertThat(orders).containsExactly(new RobotOrder.GetMap());
        later(0.5);
        at(0, 0, 0);
        assertThat(outcomes).isEmpty();
        map(PNG);

        assertThat(outcomes).containsExactly(new Outcome.Succeeded());
        assertThat(news).hasAtLeastOneElementOfType(DroneEvent.MapReported.class);
    }

    @Test
    void aMapThatIsNoPictureIsNone() {
        begin(new ReadMap());
        for (int second = 0; second < 12; second++) {
            later(1);
            map("<svg onload=alert(1)>".getBytes(StandardCharsets.US_ASCII));
        }

        assertThat(outcomes)
                .containsExactly(new Outcome.Failed(
                        "The robot does not report that it did: what it sent as its map is no picture."));
        assertThat(news).doesNotHaveAnyElementsOfTypes(DroneEvent.MapReported.class);
        assertThat(unreadable).isEqualTo(12);
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

    private void at(double x, double y, double speed) {
        Triple none = new Triple(0.0, 0.0, 0.0);
        hears(new RobotMessage.Motion(
                new Triple(x, y, 0.0), new Triple(speed, 0.0, 0.0), none, new Angles(null, null, null)));
    }

    private void map(byte[] picture) {
        hears(new RobotMessage.MapImage(Base64.getEncoder().encodeToString(picture), 20.0, 20.0, -10.0, -10.0, null));
    }

    private void hears(RobotMessage message) {
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
