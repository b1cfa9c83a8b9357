package org.dronemap.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronemap.mavlink.message.CameraFeedback;
import org.dronemap.mavlink.message.CameraImageCaptured;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.GimbalDeviceAttitudeStatus;
import org.dronemap.mavlink.message.GimbalManagerSetPitchyaw;
import org.dronemap.mavlink.message.HomePosition;
import org.dronemap.mavlink.message.MissionCurrent;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionItemReached;
import org.dronemap.mavlink.message.MissionWritePartialList;
import org.dronemap.mavlink.message.NamedValueFloat;
import org.dronemap.mavlink.message.ServoOutputRaw;
import org.dronemap.sim.control.SimulatorControlCommands;
import org.junit.jupiter.api.Test;

class SimulatedPayloadTest {
    private static final int UNSUPPORTED = 3;
    private static final int FAILED = 4;

    private static double yaw(VehicleTestBench bench) {
        return (Math.toDegrees(bench.vehicle.craft().body().yaw()) + 360) % 360;
    }

    private static String payload(VehicleTestBench bench) {
        return SimulatorControlCommands.run("payload", List.of(bench.vehicle));
    }

    @Test
    void turnsTheLongWayRoundAtTheRateAskedFor() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        double before = yaw(bench);
        assertThat(bench.command(115, 270, 30, 1, 1)).isZero();
        bench.run(3);
        assertThat(yaw(bench) - before).isBetween(80.0, 100.0);
        bench.run(3);
        assertThat(yaw(bench) - before).isBetween(170.0, 190.0);
        bench.run(4);
        assertThat(yaw(bench) - before).isBetween(269.0, 271.0);
    }

    @Test
    void turnsLeftWhenToldTo() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        double before = yaw(bench);
        assertThat(bench.command(115, 90, 0, -1, 1)).isZero();
        bench.run(3);
        assertThat((before - yaw(bench) + 360) % 360).isBetween(89.0, 91.0);
        assertThat(bench.height()).isBetween(19.0, 21.0);
    }

    @Test
    void arduCopterCountsEveryPictureAndTellsOfIt() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        assertThat(bench.command(2000, 0, 0, 1, 5)).isZero();
        assertThat(bench.command(203, 0, 0, 0, 0, 1)).isZero();
        assertThat(bench.count(CameraFeedback.ID)).isEqualTo(2);
        CameraFeedback last =
                CameraFeedback.decode(bench.heard.get(bench.heard.size() - 2).frame());
        assertThat(last.imgIdx()).isEqualTo(2);
        assertThat(last.altRel()).isBetween(19f, 21f);
        assertThat(payload(bench)).contains("pictures 2");
    }

    @Test
    void tellsWhereItTrulyIsWhateverItSaysOfItself() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        SimulatorControlCommands.run("fault all gps off", List.of(bench.vehicle));
        bench.run(1);

        assertThat(SimulatorControlCommands.run("where", List.of(bench.vehicle)))
                .matches("(?s)1 47\\.397\\d{4} 8\\.545\\d{4} (19|20)\\.\\d\\d\\Rok 1 vehicles");
    }

    private static GimbalManagerSetPitchyaw looks(int flags, double degrees) {
        return new GimbalManagerSetPitchyaw(1, 1, flags, 0, (float) Math.toRadians(degrees), 0, Float.NaN, Float.NaN);
    }

    @Test
    void aGimbalLooksWhereItIsToldAndToTheMiddleWhenItIsLetGo() {
        VehicleTestBench bench = VehicleTestBench.flying(20, "--parameter", "MNT1_TYPE=1");
        bench.run(1);
        assertThat(bench.count(GimbalDeviceAttitudeStatus.ID)).isPositive();
        bench.send(looks(12, -60));
        bench.run(0.5);
        assertThat(payload(bench)).containsPattern("gimbal -(2|3)\\d\\.");
        bench.run(1);
        assertThat(payload(bench)).contains("gimbal -60.0");
        bench.send(looks(2, Double.NaN));
        bench.run(2);
        assertThat(payload(bench)).contains("gimbal 0.0");
    }

    @Test
    void whoCarriesNoGimbalTellsOfNone() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        bench.send(looks(12, -60));
        bench.run(2);
        assertThat(bench.count(GimbalDeviceAttitudeStatus.ID)).isZero();
        assertThat(payload(bench)).doesNotContain("gimbal");
    }

    @Test
    void px4TakesPicturesByItsOlderOrderOnly() {
        VehicleTestBench bench = VehicleTestBench.ready("--personality", "px4");
        assertThat(bench.command(2000, 0, 0, 1, 5)).isEqualTo(UNSUPPORTED);
        assertThat(bench.command(203, 0, 0, 0, 0, 1)).isZero();
        assertThat(bench.count(CameraImageCaptured.ID)).isOne();
        assertThat(bench.command(181, 0, 1)).isEqualTo(UNSUPPORTED);
        assertThat(payload(bench)).contains("pictures 1");
    }

    /** Home, up to 20 m, 40 m north: look back, servo 9, a picture, six seconds, look ahead, 80 m north, home. */
    private static void uploadTasks(VehicleTestBench bench) {
        bench.upload(
                bench.item(0, 16, 0, 0, 0),
                bench.item(1, 22, 0, 0, 20),
                bench.item(2, 16, 40, 0, 20),
                lookHome(bench, 3),
                order(bench, 4, 183, 9, 1_900),
                order(bench, 5, 203, 0, 0),
                order(bench, 6, 93, 6, 0),
                order(bench, 7, 201, 0, 0),
                bench.item(8, 16, 80, 0, 20),
                bench.item(9, 20, 0, 0, 0));
    }

    private static MissionItemInt order(VehicleTestBench bench, int seq, int command, float first, float second) {
        int x = command == 203 ? 1 : 0;
        return new MissionItemInt(1, 1, seq, 2, command, 0, 1, first, second, 0, 0, x, 0, 0, 0);
    }

    private static MissionItemInt lookHome(VehicleTestBench bench, int seq) {
        MissionItemInt home = bench.item(seq, 16, 0, 0, 0);
        return new MissionItemInt(1, 1, seq, 3, 201, 0, 1, 0, 0, 0, 0, home.x(), home.y(), 0, 0);
    }

    private static void fly(VehicleTestBench bench) {
        bench.command(176, 1, 4);
        bench.command(400, 1);
        bench.command(176, 1, 3);
        bench.command(300);
    }

    private static void runUntilReached(VehicleTestBench bench, int item) {
        for (int i = 0; i < 900; i++) {
            bench.run(0.1);
            if (bench.heard.stream()
                    .filter(heard -> heard.frame().messageId() == MissionItemReached.ID)
                    .anyMatch(heard -> MissionItemReached.decode(heard.frame()).seq() == item)) {
                return;
            }
        }
        throw new AssertionError("item " + item + " was never reached");
    }

    @Test
    void arduCopterDoesTheTasksOfItsMissionWhereItIs() {
        VehicleTestBench bench = VehicleTestBench.ready();
        uploadTasks(bench);
        fly(bench);
        runUntilReached(bench, 5);
        CameraFeedback photo = bench.heard.stream()
                .filter(heard -> heard.frame().messageId() == CameraFeedback.ID)
                .map(heard -> CameraFeedback.decode(heard.frame()))
                .findFirst()
                .orElseThrow();
        assertThat(photo.imgIdx()).isOne();
        assertThat(Math.abs(photo.lat() - bench.item(0, 16, 40, 0, 0).x())).isLessThan(300);
        assertThat(payload(bench)).contains("pictures 1").contains("servo 9: 1900");
        bench.run(5);
        assertThat(Math.abs(yaw(bench) - 180)).as("it looks back to its home").isLessThan(10);
        assertThat(bench.vehicle.autopilot().currentItem())
                .as("it waits for six seconds")
                .isEqualTo(6);
        runUntilReached(bench, 9);
        assertThat(payload(bench)).as("done once").contains("pictures 1");
    }

    @Test
    void arduCopterThatIsHeldWhileItWaitsTakesNoSecondPicture() {
        VehicleTestBench bench = VehicleTestBench.ready();
        uploadTasks(bench);
        fly(bench);
        runUntilReached(bench, 5);
        bench.run(1);
        bench.command(176, 1, 17);
        bench.run(5);
        bench.command(176, 1, 3);
        bench.run(2);
        assertThat(bench.vehicle.autopilot().currentItem()).as("it waits anew").isEqualTo(6);
        runUntilReached(bench, 9);
        assertThat(payload(bench)).contains("pictures 1");
    }

    @Test
    void leavesTheOutputsOfItsMotorsAlone() {
        VehicleTestBench bench = VehicleTestBench.ready();
        assertThat(bench.vehicle.autopilot().payload().setServo(4, 1_900)).isFalse();
        assertThat(bench.vehicle.autopilot().payload().setServo(17, 1_900)).isFalse();
        assertThat(bench.vehicle.autopilot().payload().setServo(5, 1_900)).isTrue();
        bench.command(511, ServoOutputRaw.ID, 500_000);
        bench.run(1);
        ServoOutputRaw told = bench.heard.stream()
                .filter(heard -> heard.frame().messageId() == ServoOutputRaw.ID)
                .map(heard -> ServoOutputRaw.decode(heard.frame()))
                .findFirst()
                .orElseThrow();
        assertThat(told.servo5Raw()).isEqualTo(1_900);
        assertThat(told.servo6Raw()).isZero();
    }

    @Test
    void tellsWhatItsSensorsMeasure() {
        VehicleTestBench bench = VehicleTestBench.ready();
        assertThat(SimulatorControlCommands.run("sensor 1 Temp 21.5", List.of(bench.vehicle)))
                .startsWith("ok");
        bench.run(2);
        assertThat(bench.heard.stream()
                        .filter(heard -> heard.frame().messageId() == NamedValueFloat.ID)
                        .map(heard -> NamedValueFloat.decode(heard.frame())))
                .hasSizeBetween(3, 5)
                .allMatch(told -> told.name().equals("Temp") && told.value() == 21.5f);
        assertThat(SimulatorControlCommands.run("sensor 1 off", List.of(bench.vehicle)))
                .startsWith("ok");
        bench.heard.clear();
        bench.run(2);
        assertThat(bench.count(NamedValueFloat.ID)).isZero();
        assertThat(SimulatorControlCommands.run("sensor 1 Temp", List.of(bench.vehicle)))
                .startsWith("err");
    }

    @Test
    void switchesItsSixRelays() {
        VehicleTestBench bench = VehicleTestBench.ready();
        assertThat(bench.command(181, 2, 1)).isZero();
        assertThat(bench.command(181, 3, 2)).isZero();
        assertThat(bench.command(181, 4, 2)).isZero();
        assertThat(bench.command(181, 4, 2)).isZero();
        assertThat(bench.command(181, 6, 1)).isEqualTo(FAILED);
        assertThat(payload(bench)).contains("relays on: 2 3\n");
        assertThat(bench.command(181, 2, 0)).isZero();
        assertThat(payload(bench)).contains("relays on: 3\n");
    }

    @Test
    void takesAHomeInTheFrameThatIsNamed() {
        VehicleTestBench bench = VehicleTestBench.ready();
        double before = bench.vehicle.craft().home().altitudeAmsl();
        bench.send(new CommandInt(1, 1, 3, 179, 0, 0, 0, 0, 0, 0, 473_000_000, 85_000_000, 10));
        assertThat(bench.vehicle.craft().home().altitudeAmsl()).isEqualTo(before + 10);
        bench.send(new CommandInt(1, 1, 0, 179, 0, 0, 0, 0, 0, 0, 473_000_000, 85_000_000, 510));
        assertThat(bench.vehicle.craft().home().altitudeAmsl()).isEqualTo(510);
        assertThat(bench.count(HomePosition.ID)).isEqualTo(2);
    }

    @Test
    void px4TakesAHomeAboveTheSea() {
        VehicleTestBench bench = VehicleTestBench.ready("--personality", "px4");
        bench.send(new CommandInt(1, 1, 0, 179, 0, 0, 0, 0, 0, Float.NaN, 473_000_000, 85_000_000, 510));
        assertThat(bench.vehicle.craft().home().altitudeAmsl()).isEqualTo(510);
        assertThat(bench.vehicle.craft().home().latitude()).isEqualTo(47.3);
    }

    @Test
    void arduCopterTakesAPartOfAMissionInPlace() {
        VehicleTestBench bench = VehicleTestBench.ready();
        bench.upload(bench.item(0, 16, 0, 0, 0), bench.item(1, 22, 0, 0, 20), bench.item(2, 16, 40, 0, 20));
        bench.send(new MissionWritePartialList(1, 1, 2, 2, 0));
        bench.send(bench.item(2, 16, 80, 0, 35));
        assertThat(bench.vehicle.autopilot().plan().size()).isEqualTo(3);
        assertThat(bench.vehicle.autopilot().plan().item(1).command()).isEqualTo(22);
        assertThat(bench.vehicle.autopilot().plan().item(2).z()).isEqualTo(35f);
        bench.send(new MissionWritePartialList(1, 1, 2, 5, 0));
        assertThat(bench.texts()).contains("Flight plan received", "Flight plan update rejected");
    }

    @Test
    void px4GivesEveryMissionANumberOfItsOwn() {
        VehicleTestBench bench = VehicleTestBench.ready("--personality", "px4");
        MissionItemInt[] items = {bench.item(0, 22, 0, 0, 20), bench.item(1, 16, 40, 0, 20)};
        bench.upload(items);
        bench.run(2);
        long first = stamp(bench);
        bench.run(2);
        assertThat(stamp(bench)).isEqualTo(first).isNotZero();
        bench.upload(items);
        bench.run(2);
        assertThat(stamp(bench)).isNotEqualTo(first).isNotZero();
    }

    private static long stamp(VehicleTestBench bench) {
        return bench.heard.stream()
                .filter(h -> h.frame().messageId() == MissionCurrent.ID)
                .reduce((one, later) -> later)
                .orElseThrow()
                .frame()
                .u32(6);
    }
}
