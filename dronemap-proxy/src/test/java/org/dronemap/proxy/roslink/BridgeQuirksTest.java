package org.dronemap.proxy.roslink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.EmergencyStop;
import org.dronemap.core.command.GoToLocal;
import org.dronemap.core.command.ReadMap;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.LocalPosition;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.proxy.roslink.wire.PacketReadResult;
import org.dronemap.proxy.roslink.wire.RobotMessage;
import org.dronemap.proxy.roslink.wire.RobotOrder;
import org.dronemap.proxy.roslink.wire.RoslinkPacketReader;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Oddities of the bridges in the field that need no socket to be seen. */
class BridgeQuirksTest {
    private final List<DroneEvent> news = new ArrayList<>();

    /** It ends the thread of a bridge that takes orders. */
    @Test
    void noOrderIsAnAcknowledgement() {
        assertThat(Arrays.stream(RobotOrder.class.getPermittedSubclasses()).map(Class::getSimpleName))
                .as("one more kind needs its number here")
                .containsExactlyInAnyOrder(
                        "Twist",
                        "GoTo",
                        "TakeOff",
                        "Land",
                        "Arm",
                        "Disarm",
                        "SetMode",
                        "GetMap",
                        "EmergencyStop",
                        "Heartbeat");
        List<RobotOrder> all = List.of(
                RobotOrder.Twist.STOP,
                new RobotOrder.GoTo(0, 0, 0, false),
                new RobotOrder.TakeOff(1),
                new RobotOrder.Land(),
                new RobotOrder.Arm(),
                new RobotOrder.Disarm(),
                new RobotOrder.SetMode(4),
                new RobotOrder.GetMap(),
                new RobotOrder.EmergencyStop(),
                new RobotOrder.Heartbeat());
        assertThat(all.stream().map(RobotOrder::messageId))
                .containsExactly(100, 101, 102, 103, 104, 105, 106, 107, 108, 0);
    }

    /** The field is called milliseconds since the start, and holds seconds since 1970, or something else. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "\"time_boot_ms\":1511431926.25,",
                "\"time_boot_ms\":1511431926250,",
                "\"time_boot_ms\":-1,",
                "\"time_boot_ms\":\"now\","
            })
    void whatATimeSaysChangesNothing(String time) {
        robot(RobotType.TURTLEBOT).received(read(2, time + "\"x\":1,\"y\":2,\"z\":0"));

        assertThat(news).contains(new DroneEvent.LocalPositionReported(new LocalPosition(1, 2, null, 0.0)));
    }

    /** They always say mode 0, which behind mavros would be a mode of its own, and state 2. */
    @Test
    void aHeartbeatSaysNeitherModeNorState() {
        RobotTelemetryTranslator drone = robot(RobotType.GAPTER);
        drone.received(read(0, "\"type\":2,\"name\":\"gapter\",\"system_status\":2,\"owner_id\":1,\"mode\":0"));
        drone.received(read(1, "\"type\":2,\"name\":\"gapter\",\"system_status\":3,\"owner_id\":1,\"mode\":0"));

        assertThat(news).isEmpty();
        assertThat(drone.facts()).isEqualTo(RobotStatus.NONE);
    }

    @ParameterizedTest
    @CsvSource({
        "0,GENERIC",
        "1,FIXED_WING",
        "2,GAPTER",
        "3,QUADROTOR",
        "4,COAXIAL",
        "5,HELICOPTER",
        "6,HEXAROTOR",
        "7,GENERIC",
        "8,TURTLEBOT",
        "9,PARROT",
        "10,BEBOP",
        "11,ERLE_COPTER",
        "12,RIA_E100"
    })
    void eachNumberOfATypeIsAKindOfRobot(int number, RobotType type) {
        assertThat(RobotType.of(number)).isEqualTo(type);
    }

    @ParameterizedTest
    @CsvSource({"0,STABILIZE", "2,ALT_HOLD", "3,AUTO", "4,GUIDED", "5,LOITER", "6,RTL", "9,LAND"})
    void aModeIsSetByItsNumber(int number, String mode) {
        assertThat(RobotGoal.of(new Command.SetMode(mode)).orElseThrow().order(RobotStatus.NONE))
                .isEqualTo(new RobotOrder.SetMode(number));
    }

    /** A bridge fails at any other number. */
    @ParameterizedTest
    @ValueSource(strings = {"ACRO", "POSHOLD", "BRAKE", "4", "guided", ""})
    void noOtherModeIsEverSet(String mode) {
        assertThat(RobotGoal.of(new Command.SetMode(mode))).isEmpty();
    }

    /** They do not listen to it. */
    @ParameterizedTest
    @EnumSource(
            value = RobotType.class,
            names = {"GENERIC", "TURTLEBOT", "RIA_E100"},
            mode = EnumSource.Mode.EXCLUDE)
    void noDroneIsSentToAPlaceOfAMap(RobotType type) {
        assertThat(robot(type).capabilities().commands())
                .doesNotContain(Capability.GO_TO_LOCAL, Capability.READ_MAP, Capability.EMERGENCY_STOP);
    }

    @Test
    void aPlaceIsInTheFrameOfTheMap() {
        assertThat(RobotGoal.of(new GoToLocal(1, 2, null)).orElseThrow().order(RobotStatus.NONE))
                .isEqualTo(new RobotOrder.GoTo(1, 2, 0, false));
    }

    /** One bridge stops and then dies of it. */
    @Test
    void anEmergencyStopIsSaidOnceAndZerosUntilItStands() {
        RobotGoal stop = RobotGoal.of(new EmergencyStop()).orElseThrow();
        assertThat(stop.opening()).contains(new RobotOrder.EmergencyStop());
        assertThat(stop.order(RobotStatus.NONE)).isEqualTo(RobotOrder.Twist.STOP);
    }

    @Test
    void aMapIsAskedForAndComesAsAMessage() {
        RobotGoal map = RobotGoal.of(new ReadMap()).orElseThrow();
        assertThat(map.order(RobotStatus.NONE)).isEqualTo(new RobotOrder.GetMap());
        assertThat(map.isAbout(read(6, "\"data\":\"/9j/4AEC\",\"height\":200,\"width\":200")))
                .isTrue();
        assertThat(map.isAbout(read(5, "\"data\":\"/9j/4AEC\""))).isFalse();
    }

    /** Angles are in radians, and a drone's heading is not its z. */
    @Test
    void aHeadingOfADroneIsInRadians() {
        robot(RobotType.GAPTER).received(read(2, "\"x\":0,\"y\":0,\"z\":4,\"heading\":1.5707963267948966"));

        assertThat(news).contains(new DroneEvent.LocalPositionReported(new LocalPosition(0, 0, 4.0, 90.0)));
    }

    private RobotTelemetryTranslator robot(RobotType type) {
        return new RobotTelemetryTranslator(type, null, news::add, () -> {});
    }

    private static RobotMessage read(int messageId, String body) {
        String text = "{\"header\":{\"system_id\":7,\"message_id\":" + messageId + "}," + body + "}";
        PacketReadResult reading =
                new RoslinkPacketReader().read(ByteBuffer.wrap(text.getBytes(StandardCharsets.UTF_8)));
        return ((PacketReadResult.Good) reading).packet().message();
    }
}
