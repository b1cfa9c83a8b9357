package org.dronemap.proxy.roslink;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.LocalPosition;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.proxy.roslink.wire.RobotMessage;
import org.dronemap.proxy.roslink.wire.RobotMessage.Angles;
import org.dronemap.proxy.roslink.wire.RobotMessage.Triple;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

class RobotTelemetryTranslatorTest {
    private final List<DroneEvent> news = new ArrayList<>();

    @Test
    void takesThePartsOfAStateApart() {
        robot(RobotType.GAPTER).received(new RobotMessage.Status(4_104, null, null, null));

        assertThat(news)
                .containsExactly(
                        new DroneEvent.ModeReported("GUIDED", true), new DroneEvent.PhaseReported(FlightPhase.IN_AIR));
    }

    @Test
    void hasNoNameForAModeThatBridgesCannotSet() {
        robot(RobotType.GAPTER).received(new RobotMessage.Status(3_016, null, null, null));

        assertThat(news).first().isEqualTo(new DroneEvent.ModeReported(null, false));
    }

    @Test
    void saysWhereAnArDroneIsBetweenGroundAndAir() {
        RobotTelemetryTranslator drone = robot(RobotType.PARROT);
        for (int state : new int[] {2, 5, 4, 0, 0, 77}) {
            drone.received(new RobotMessage.Status(state, null, null, null));
        }

        assertThat(news)
                .filteredOn(DroneEvent.PhaseReported.class::isInstance)
                .containsExactly(
                        new DroneEvent.PhaseReported(FlightPhase.ON_GROUND),
                        new DroneEvent.PhaseReported(FlightPhase.TAKING_OFF),
                        new DroneEvent.PhaseReported(FlightPhase.IN_AIR));
        assertThat(news).filteredOn(DroneEvent.TextReported.class::isInstance).hasSize(1);
    }

    @Test
    void takesZForAYawOnWheelsAndForAHeightInTheAir() {
        robot(RobotType.TURTLEBOT).received(motion(1, 2, Math.PI / 2));
        assertThat(news)
                .containsExactly(
                        new DroneEvent.LocalPositionReported(new LocalPosition(1, 2, null, 90.0)),
                        new DroneEvent.MotionReported(new Motion(0.5, null, null, null)));

        news.clear();
        robot(RobotType.QUADROTOR).received(motion(1, 2, 7.0));
        assertThat(news)
                .contains(
                        new DroneEvent.LocalPositionReported(new LocalPosition(1, 2, 7.0, null)),
                        new DroneEvent.PositionReported(new Position(null, null, 7.0)));
    }

    @Test
    void tellsNoBatteryWhereNoneIsMeasured() {
        RobotTelemetryTranslator robot = robot(RobotType.TURTLEBOT);
        robot.received(new RobotMessage.Status(0, 0.0, 0.0, 0.0));
        robot.received(new RobotMessage.Status(null, null, null, null));
        robot.received(new RobotMessage.Status(0, -1.0, null, -1.0));

        assertThat(news).isEmpty();
    }

    @Test
    void tellsVoltsWhetherABridgeSendsThemOrMillivolts() {
        RobotTelemetryTranslator robot = robot(RobotType.TURTLEBOT);
        robot.received(new RobotMessage.Status(null, 11_900.0, null, 80.0));
        robot.received(new RobotMessage.Status(null, 11.9, null, 0.0));

        assertThat(news)
                .containsExactly(
                        new DroneEvent.BatteryReported(new Battery(80, 11.9, null)),
                        new DroneEvent.BatteryReported(new Battery(0, 11.9, null)));
    }

    @Test
    void tellsPerCentWhereABridgeKnowsNothingElse() {
        robot(RobotType.TURTLEBOT).received(new RobotMessage.Status(null, null, null, 83.0));

        assertThat(news).containsExactly(new DroneEvent.BatteryReported(new Battery(83, null, null)));
    }

    @Test
    void tellsNoPlaceWhereTheReceiverHasNone() {
        RobotTelemetryTranslator robot = robot(RobotType.GAPTER);
        robot.received(new RobotMessage.Satellites(0, 0.0, 0.0, 0.0, null));
        robot.received(new RobotMessage.Satellites(3, null, 46.0, 1.0, null));
        robot.received(new RobotMessage.Satellites(-1, 24.0, 46.0, 1.0, null));
        robot.received(new RobotMessage.Satellites(3, 240.0, 46.0, 1.0, null));

        assertThat(news).noneMatch(DroneEvent.PositionReported.class::isInstance);
    }

    @Test
    void takesAnAltitudeThatIsNeverFilledForUnknown() {
        robot(RobotType.GAPTER).received(new RobotMessage.Satellites(3, 24.5, 46.5, 0.0, 9));

        assertThat(news).contains(new DroneEvent.PositionReported(new Position(new Geodetic(24.5, 46.5), null, null)));
    }

    @Test
    void declaresWhatEachKindOfRobotCanDo() {
        assertThat(robot(RobotType.TURTLEBOT).capabilities().commands())
                .containsExactlyInAnyOrder(
                        Capability.HOLD,
                        Capability.EMERGENCY_STOP,
                        Capability.GO_TO_LOCAL,
                        Capability.READ_MAP,
                        Capability.VELOCITY);
        assertThat(robot(RobotType.BEBOP).capabilities().commands())
                .contains(Capability.TAKE_OFF, Capability.LAND, Capability.VELOCITY)
                .doesNotContain(Capability.ARM, Capability.SET_MODE, Capability.GO_TO_LOCAL);
        assertThat(robot(RobotType.GAPTER).capabilities().modes()).contains("GUIDED", "RTL");
        assertThat(robot(RobotType.TURTLEBOT).identification().kind()).isEqualTo(VehicleKind.ROVER);
        assertThat(RobotType.of(4711)).isEqualTo(RobotType.GENERIC);
        assertThat(RobotType.of(null)).isEqualTo(RobotType.GENERIC);
    }

    private RobotTelemetryTranslator robot(RobotType type) {
        return new RobotTelemetryTranslator(type, null, news::add, () -> {});
    }

    private static RobotMessage motion(double x, double y, @Nullable Double z) {
        return new RobotMessage.Motion(
                new Triple(x, y, z),
                new Triple(0.3, 0.4, null),
                new Triple(null, null, 0.0),
                new Angles(null, null, null));
    }
}
