package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.dronemap.core.command.ChangeSpeed;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.ParamValue;
import org.dronemap.proxy.mavlink.procedure.TestWire;
import org.junit.jupiter.api.Test;

/** How an autopilot is told a speed, and that it keeps it with the next place that it is sent to. */
class SpeedExchangesTest {
    private static final int FIXED_WING = 1;
    private static final int QUADROTOR = 2;
    private static final int ROVER = 10;
    private static final int CHANGE_SPEED = 178;
    private static final int REPOSITION = 192;
    private static final int ACCEPTED = 0;
    private static final int FAILED = 4;
    private static final Command THERE = new Command.GoTo(new Geodetic(46, 7), Altitude.aboveHome(25));
    private static final Heartbeat PX4_LOITERS = new Heartbeat(2, 12, 209, 4 << 16 | 3 << 24, 4, 3);

    private final Map<Integer, Integer> answers = new TreeMap<>();

    private static Heartbeat ardu(int type, int mode) {
        return new Heartbeat(type, 3, 209, mode, 4, 3);
    }

    private AutopilotTestBench vehicle(Heartbeat heartbeat) {
        AutopilotTestBench bench = new AutopilotTestBench(heartbeat);
        bench.wire.peer(this::answer);
        return bench;
    }

    private void answer(TestWire wire, Message message) {
        int command = message instanceof CommandLong asked
                ? asked.command()
                : message instanceof CommandInt asked ? asked.command() : 0;
        if (command != 0) {
            wire.answer(new CommandAck(command, answers.getOrDefault(command, ACCEPTED), 0, 0, 255, 190));
        }
    }

    private static List<CommandLong> speeds(AutopilotTestBench bench) {
        return bench.wire.sent(CommandLong.class).stream()
                .filter(sent -> sent.command() == CHANGE_SPEED)
                .toList();
    }

    @Test
    void asksCoptersAndRoversForASpeedOverTheGround() {
        for (Heartbeat heartbeat : List.of(ardu(QUADROTOR, 4), ardu(ROVER, 15), PX4_LOITERS)) {
            AutopilotTestBench bench = vehicle(heartbeat);

            assertThat(bench.perform(new ChangeSpeed(4.5))).isInstanceOf(Outcome.Succeeded.class);
            assertThat(speeds(bench)).singleElement().satisfies(sent -> {
                assertThat(sent.param1()).isEqualTo(1f);
                assertThat(sent.param2()).isEqualTo(4.5f);
                assertThat(sent.param3()).isEqualTo(-1f);
            });
        }
    }

    @Test
    void asksPlanesForASpeedThroughTheAir() {
        AutopilotTestBench plane = vehicle(ardu(FIXED_WING, 15));

        assertThat(plane.perform(new ChangeSpeed(19))).isInstanceOf(Outcome.Succeeded.class);
        assertThat(speeds(plane))
                .singleElement()
                .satisfies(sent -> assertThat(sent.param1()).isZero());
    }

    @Test
    void saysInWhichModesAPlaneGoesByOneAndSendsNothing() {
        int loiter = 12;
        AutopilotTestBench plane = vehicle(ardu(FIXED_WING, loiter));

        assertThat(plane.perform(new ChangeSpeed(19)))
                .isEqualTo(new Outcome.Refused(
                        "gate",
                        "A plane goes by such a speed in GUIDED and AUTO only; change its mode first.",
                        OutcomeCode.MODE_NOT_STEERABLE));
        assertThat(plane.wire.sent()).isEmpty();
    }

    @Test
    void namesTheBoundsOfAPlaneThatToldThem() {
        AutopilotTestBench plane = vehicle(ardu(FIXED_WING, 15));
        plane.told(new ParamValue("AIRSPEED_MIN", 11f, 9, 2, 0));
        plane.told(new ParamValue("AIRSPEED_MAX", 27f, 9, 2, 1));

        assertThat(plane.perform(new ChangeSpeed(28))).satisfies(outcome -> {
            assertThat(outcome.code()).isEqualTo(OutcomeCode.SPEED_NOT_POSSIBLE);
            assertThat(outcome.reason())
                    .isEqualTo("metersPerSecond must be 11.0 to 27.0 for this plane (its AIRSPEED_MIN and"
                            + " AIRSPEED_MAX), not 28.0.");
        });
        assertThat(plane.wire.sent()).isEmpty();
        assertThat(plane.perform(new ChangeSpeed(27))).isInstanceOf(Outcome.Succeeded.class);
    }

    @Test
    void explainsThePlaneThatGivesNoReason() {
        answers.put(CHANGE_SPEED, FAILED);
        AutopilotTestBench plane = vehicle(ardu(FIXED_WING, 15));

        assertThat(plane.perform(new ChangeSpeed(80))).satisfies(outcome -> {
            assertThat(outcome.code()).isEqualTo(OutcomeCode.VEHICLE_FAILED);
            assertThat(outcome.reason()).contains("gave no reason. A plane takes only speeds", "AIRSPEED_MIN");
        });
    }

    @Test
    void repeatsItWithTheNextPlaceAsACopterForgetsIt() {
        AutopilotTestBench copter = vehicle(ardu(QUADROTOR, 4));

        copter.perform(THERE);
        assertThat(speeds(copter)).isEmpty();

        copter.perform(new ChangeSpeed(3));
        assertThat(copter.perform(THERE)).isInstanceOf(Outcome.Succeeded.class);
        assertThat(speeds(copter))
                .hasSize(2)
                .allSatisfy(sent -> assertThat(sent.param2()).isEqualTo(3f));
        assertThat(copter.wire.sent().get(copter.wire.sent().size() - 1)).isInstanceOf(CommandLong.class);
    }

    @Test
    void forgetsItWithTheModeAsTheVehicleDoes() {
        AutopilotTestBench copter = vehicle(ardu(QUADROTOR, 4));
        copter.perform(new ChangeSpeed(3));

        copter.status.heartbeat(ardu(QUADROTOR, 17), "BRAKE");
        copter.status.heartbeat(ardu(QUADROTOR, 4), "GUIDED");
        copter.perform(THERE);

        assertThat(speeds(copter)).hasSize(1);
    }

    @Test
    void doesNotKeepASpeedThatWasRefused() {
        answers.put(CHANGE_SPEED, FAILED);
        AutopilotTestBench copter = vehicle(ardu(QUADROTOR, 4));

        assertThat(copter.perform(new ChangeSpeed(3))).isInstanceOf(Outcome.Refused.class);
        copter.perform(THERE);

        assertThat(speeds(copter)).hasSize(1);
    }

    @Test
    void goesThereAllTheSameAndWarns() {
        AutopilotTestBench copter = vehicle(ardu(QUADROTOR, 4));
        copter.perform(new ChangeSpeed(3));
        answers.put(CHANGE_SPEED, FAILED);

        assertThat(copter.perform(THERE)).isInstanceOf(Outcome.Succeeded.class);
        assertThat(copter.warnings).singleElement().asString().contains("not at the speed that it was told before");
    }

    @Test
    void tellsPx4TheSpeedWithThePlace() {
        AutopilotTestBench px4 = vehicle(PX4_LOITERS);
        px4.status.home(460_000_000, 70_000_000, 400);

        px4.perform(THERE);
        px4.perform(new ChangeSpeed(6));
        px4.perform(THERE);

        assertThat(px4.wire.sent(CommandInt.class))
                .filteredOn(sent -> sent.command() == REPOSITION)
                .extracting(CommandInt::param1)
                .startsWith(-1f, 6f)
                .containsOnly(-1f, 6f);
    }
}
