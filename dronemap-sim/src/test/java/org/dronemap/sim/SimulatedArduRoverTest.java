package org.dronemap.sim;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.sim.physics.NeuPosition;
import org.junit.jupiter.api.Test;

/** What recordings of a real ArduRover do not show of the simulated one. */
class SimulatedArduRoverTest {
    private static final int MANUAL = 0;
    private static final int HOLD = 4;
    private static final int LOITER = 5;
    private static final int AUTO = 10;
    private static final int RTL = 11;
    private static final int SMART_RTL = 12;
    private static final int GUIDED = 15;
    private static final String[] ROVER = {"--personality", "ardurover"};

    private static VehicleTestBench armed(int mode) {
        VehicleTestBench bench = VehicleTestBench.ready(ROVER);
        bench.command(176, 1, mode);
        bench.command(400, 1);
        bench.heard.clear();
        return bench;
    }

    private static void goTo(VehicleTestBench bench, double north, double east, float altitude) {
        NeuPosition place = new NeuPosition(north, east, 0);
        var home = bench.vehicle.craft().home();
        bench.send(new SetPositionTargetGlobalInt(
                0,
                1,
                1,
                6,
                0b0000_1101_1111_1000,
                (int) Math.round(home.latitudeOf(place) * 1e7),
                (int) Math.round(home.longitudeOf(place) * 1e7),
                altitude,
                0,
                0,
                0,
                0,
                0,
                0,
                0,
                0));
    }

    private static double away(VehicleTestBench bench, double north, double east) {
        return bench.vehicle.craft().body().position().horizontalDistanceTo(new NeuPosition(north, east, 0));
    }

    private static double speed(VehicleTestBench bench) {
        return bench.vehicle.craft().body().groundSpeed();
    }

    @Test
    void isARoverAndABoatIfItsFrameIsOne() {
        assertThat(VehicleTestBench.ready(ROVER).beat().type()).isEqualTo(10);
        assertThat(VehicleTestBench.ready("--personality", "ardurover", "--parameter", "FRAME_CLASS=2")
                        .beat()
                        .type())
                .isEqualTo(11);
    }

    @Test
    void neverLeavesTheGroundHoweverHighItsTargetIs() {
        VehicleTestBench bench = armed(GUIDED);
        goTo(bench, 40, 20, 30);
        bench.run(30);
        assertThat(bench.vehicle.craft().body().up()).isZero();
        assertThat(away(bench, 40, 20)).isLessThan(1);
        assertThat(speed(bench)).isLessThan(0.1);
    }

    /** The altitude of its home was taken before there was one: the ground reads as hundreds of metres above it. */
    @Test
    void readsAsFarAboveHomeUntilItHasBeenMoved() {
        VehicleTestBench bench = armed(GUIDED);
        assertThat(bench.command(511, GlobalPositionInt.ID, 200_000)).isZero();
        bench.run(1);
        assertThat(relativeAltitude(bench)).isEqualTo(488_000);
        goTo(bench, 20, 0, 0);
        bench.run(20);
        bench.command(400, 0);
        bench.run(3);
        assertThat(relativeAltitude(bench)).isZero();
    }

    private static int relativeAltitude(VehicleTestBench bench) {
        return bench.heard.stream()
                .filter(heard -> heard.frame().messageId() == GlobalPositionInt.ID)
                .mapToInt(heard -> GlobalPositionInt.decode(heard.frame()).relativeAlt())
                .reduce((first, last) -> last)
                .orElseThrow();
    }

    @Test
    void staysArmedAndInItsModeHoweverLongItStands() {
        VehicleTestBench bench = armed(HOLD);
        bench.run(120);
        assertThat(bench.armed()).isTrue();
        assertThat(bench.mode()).isEqualTo(HOLD);
    }

    @Test
    void turnsOnlyWhileItRolls() {
        VehicleTestBench bench = armed(GUIDED);
        goTo(bench, -30, 0, 0);
        bench.run(3);
        double passed = bench.vehicle.craft().body().position().north();
        assertThat(passed).as("it rolls on while it turns").isPositive();
        bench.run(25);
        assertThat(away(bench, -30, 0)).isLessThan(1);
    }

    @Test
    void standsAtHomeInRtl() {
        VehicleTestBench bench = armed(GUIDED);
        goTo(bench, 50, 0, 0);
        bench.run(25);
        assertThat(bench.command(20)).isZero();
        bench.run(40);
        assertThat(bench.mode()).isEqualTo(RTL);
        assertThat(bench.armed()).isTrue();
        assertThat(away(bench, 0, 0)).isLessThan(1);
        assertThat(bench.texts()).containsOnlyOnce("Reached destination");
    }

    @Test
    void comesHomeBySmartRtl() {
        VehicleTestBench bench = armed(GUIDED);
        goTo(bench, 50, 0, 0);
        bench.run(25);
        assertThat(bench.command(176, 1, SMART_RTL)).isZero();
        bench.run(40);
        assertThat(away(bench, 0, 0)).isLessThan(1);
    }

    @Test
    void goesOnInAutoWithTheItemThatItWasHeldAt() {
        VehicleTestBench bench = armed(HOLD);
        bench.upload(bench.item(0, 16, 0, 0, 0), bench.item(1, 16, 20, 0, 0), bench.item(2, 16, 60, 0, 0));
        bench.command(176, 1, AUTO);
        bench.run(11);
        assertThat(bench.vehicle.autopilot().currentItem()).isEqualTo(2);
        bench.command(176, 1, HOLD);
        bench.run(30);
        assertThat(speed(bench)).isLessThan(0.05);
        assertThat(bench.command(176, 1, AUTO)).isZero();
        assertThat(bench.vehicle.autopilot().currentItem()).isEqualTo(2);
        bench.run(25);
        assertThat(bench.texts()).endsWith("Reached waypoint #2", "Mission Complete");
        assertThat(bench.mode()).isEqualTo(AUTO);
        assertThat(bench.armed()).isTrue();
    }

    @Test
    void waitsWholeSecondsOnly() {
        VehicleTestBench bench = armed(HOLD);
        MissionItemInt near = bench.item(1, 16, 15, 0, 0);
        bench.upload(
                bench.item(0, 16, 0, 0, 0),
                new MissionItemInt(1, 1, 1, 3, 16, 0, 1, 2.5f, 0, 0, 0, near.x(), near.y(), 0, 0));
        bench.command(300);
        bench.run(20);
        assertThat(bench.texts()).contains("Reached waypoint #1. Loiter for 2 seconds");
    }

    @Test
    void doesAtTheEndOfItsMissionWhatItsParameterSays() {
        VehicleTestBench bench = armed(HOLD);
        bench.parameter("MIS_DONE_BEHAVE", 3);
        bench.upload(bench.item(0, 16, 0, 0, 0), bench.item(1, 16, 15, 0, 0));
        bench.command(300);
        bench.run(15);
        assertThat(bench.texts()).contains("Mission Complete");
        assertThat(bench.mode()).isEqualTo(MANUAL);
    }

    @Test
    void drivesBackIntoItsCircleWhenItLoiters() {
        VehicleTestBench bench = armed(GUIDED);
        goTo(bench, 100, 0, 0);
        bench.run(8);
        assertThat(bench.command(176, 1, LOITER)).isZero();
        bench.run(15);
        assertThat(speed(bench)).isLessThan(0.1);
        assertThat(bench.mode()).isEqualTo(LOITER);
    }

    @Test
    void takesASpeedOnlyForAWayThatItDrives() {
        VehicleTestBench bench = armed(GUIDED);
        assertThat(bench.command(178, 1, 2)).as("standing in GUIDED").isEqualTo(4);
        goTo(bench, 100, 0, 0);
        assertThat(bench.command(178, 1, 2)).as("on the way").isZero();
        bench.run(10);
        assertThat(speed(bench)).isBetween(1.9, 2.1);
    }

    @Test
    void takesAPlaceOnlyAsCommandInt() {
        VehicleTestBench bench = armed(HOLD);
        assertThat(bench.command(192, -1, 1, 0, 0, 47.398f, 8.546f, 0)).isEqualTo(3);
        bench.send(new CommandInt(1, 1, 6, 192, 0, 0, -1, 1, 0, 0, 473_980_000, 85_456_000, 0));
        assertThat(bench.mode()).isEqualTo(GUIDED);
        bench.run(30);
        assertThat(away(bench, 33.4, 0)).isLessThan(1);
    }

    @Test
    void rollsOutWhenItIsDisarmedOnTheWay() {
        VehicleTestBench bench = armed(GUIDED);
        goTo(bench, 100, 0, 0);
        bench.run(8);
        assertThat(bench.command(400, 0)).isZero();
        bench.run(10);
        assertThat(bench.armed()).isFalse();
        assertThat(speed(bench)).isLessThan(0.1);
    }
}
