package org.dronemap.sim;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.sim.physics.NeuPosition;
import org.dronemap.sim.physics.VehicleBody;
import org.junit.jupiter.api.Test;

/** What the recordings do not show of the simulated ArduPlane. */
class SimulatedArduPlaneTest {
    private static final int FLY_BY_WIRE_A = 5;
    private static final int AUTO = 10;
    private static final int RTL = 11;
    private static final int LOITER = 12;
    private static final int TAKEOFF = 13;
    private static final int GUIDED = 15;
    private static final int LAND_START = 189;
    private static final int LAND = 21;
    private static final String[] PLANE = {"--personality", "arduplane"};

    private static VehicleTestBench flying(String... options) {
        VehicleTestBench bench = VehicleTestBench.ready(options);
        bench.command(176, 1, TAKEOFF);
        bench.command(400, 1);
        bench.run(40);
        bench.heard.clear();
        return bench;
    }

    @Test
    void isNeverSlowerThanItsWingsBear() {
        VehicleTestBench bench = flying("--personality", "arduplane", "--wind", "8");
        bench.command(176, 1, LOITER);
        double slowest = Double.POSITIVE_INFINITY;
        for (int tenths = 0; tenths < 1_200; tenths++) {
            bench.run(0.1);
            slowest = Math.min(
                    slowest,
                    bench.vehicle.craft().body().airSpeed(bench.vehicle.craft().wind()));
        }
        assertThat(slowest).isGreaterThan(10);
        assertThat(bench.height()).isBetween(40.0, 60.0);
    }

    @Test
    void keepsToItsCircleInWind() {
        VehicleTestBench bench = flying("--personality", "arduplane", "--wind", "6");
        bench.command(20);
        bench.run(60);
        for (int seconds = 0; seconds < 60; seconds++) {
            bench.run(1);
            assertThat(awayFromHome(bench)).isBetween(70.0, 140.0);
        }
    }

    private static double awayFromHome(VehicleTestBench bench) {
        VehicleBody body = bench.vehicle.craft().body();
        return body.position().horizontalDistanceTo(bench.vehicle.craft().homePosition());
    }

    @Test
    void circlesToTheLeftWhenAskedTo() {
        VehicleTestBench bench = flying(PLANE);
        bench.command(176, 1, GUIDED);
        sendTo(bench, new NeuPosition(300, 0, 60), 100, 1);
        bench.run(60);
        assertThat(bench.vehicle.craft().body().yawRate()).isNegative();
        sendTo(bench, new NeuPosition(300, 0, 60), 100, 0);
        bench.run(30);
        assertThat(bench.vehicle.craft().body().yawRate()).isPositive();
    }

    private static void sendTo(VehicleTestBench bench, NeuPosition place, float radius, float left) {
        var home = bench.vehicle.craft().home();
        int latitude = (int) Math.round(home.latitudeOf(place) * 1e7);
        int longitude = (int) Math.round(home.longitudeOf(place) * 1e7);
        bench.send(new CommandInt(1, 1, 6, 192, 0, 0, -1, 0, radius, left, latitude, longitude, (float) place.up()));
    }

    @Test
    void glidesToTheGroundWhenItsMotorFails() {
        VehicleTestBench bench = flying(PLANE);
        bench.parameter("SIM_ENGINE_MUL", 0);
        bench.run(20);
        assertThat(bench.height()).isBetween(10.0, 45.0);
        bench.run(60);
        assertThat(bench.height()).isZero();
        assertThat(bench.vehicle.craft().crashed()).isFalse();
        assertThat(bench.armed()).isTrue();
    }

    @Test
    void standsStillInGuidedOnTheGround() {
        VehicleTestBench bench = VehicleTestBench.ready(PLANE);
        bench.command(176, 1, GUIDED);
        assertThat(bench.command(400, 1)).isZero();
        sendTo(bench, new NeuPosition(300, 0, 60), 0, 0);
        bench.run(20);
        assertThat(bench.vehicle.craft().body().groundSpeed()).isZero();
        assertThat(bench.height()).isZero();
    }

    @Test
    void landsByItsMissionOnALowBatteryThatIsToldTo() {
        VehicleTestBench bench = VehicleTestBench.ready(
                "--personality", "arduplane", "--parameter", "RTL_AUTOLAND=3", "--parameter", "BATT_FS_LOW_ACT=2");
        bench.upload(
                bench.item(0, 16, 0, 0, 0),
                item(bench, 1, LAND_START, 0, 0),
                item(bench, 2, 16, -500, 30),
                item(bench, 3, LAND, 0, 0));
        bench.command(176, 1, TAKEOFF);
        bench.command(400, 1);
        bench.run(40);
        bench.parameter("SIM_BATT_VOLTAGE", 10.2);
        bench.run(15);
        assertThat(bench.mode()).isEqualTo(AUTO);
        assertThat(bench.texts()).contains("Landing sequence start");
        bench.run(120);
        assertThat(bench.armed()).isFalse();
        assertThat(awayFromHome(bench)).isLessThan(60);
    }

    private static MissionItemInt item(VehicleTestBench bench, int seq, int command, double north, float up) {
        var place = new NeuPosition(north, 0, 0);
        var home = bench.vehicle.craft().home();
        int latitude = command == LAND_START ? 0 : (int) Math.round(home.latitudeOf(place) * 1e7);
        int longitude = command == LAND_START ? 0 : (int) Math.round(home.longitudeOf(place) * 1e7);
        return new MissionItemInt(1, 1, seq, 3, command, 0, 1, 0, 0, 0, 0, latitude, longitude, up, 0);
    }

    @Test
    void returnsOnALowBatteryWithoutALandingInItsMission() {
        VehicleTestBench bench = flying("--personality", "arduplane", "--parameter", "BATT_FS_LOW_ACT=2");
        bench.parameter("SIM_BATT_VOLTAGE", 10.2);
        bench.run(15);
        assertThat(bench.mode()).isEqualTo(RTL);
    }

    @Test
    void glidesWhenTheGroundStationIsLostAndItIsToldTo() {
        VehicleTestBench bench =
                flying("--personality", "arduplane", "--parameter", "FS_GCS_ENABL=1", "--parameter", "FS_LONG_ACTN=2");
        bench.command(176, 1, LOITER);
        bench.groundTalks(false);
        bench.run(8);
        assertThat(bench.mode()).isEqualTo(FLY_BY_WIRE_A);
        assertThat(bench.texts()).contains("GCS Failsafe On: FLY_BY_WIRE_A");
    }

    @Test
    void fallsBackToTheSpeedOfItsParametersInAnotherMode() {
        VehicleTestBench bench = flying(PLANE);
        bench.command(176, 1, GUIDED);
        assertThat(bench.command(178, 0, 28, -1)).isZero();
        bench.run(20);
        assertThat(bench.vehicle.craft().body().groundSpeed()).isGreaterThan(27);
        bench.command(176, 1, LOITER);
        bench.run(30);
        assertThat(bench.vehicle.craft().body().groundSpeed()).isBetween(22.0, 24.5);
    }

    @Test
    void beginsItsMissionAnewAfterItsEnd() {
        VehicleTestBench bench = VehicleTestBench.ready(PLANE);
        bench.upload(bench.item(0, 16, 0, 0, 0), bench.item(1, 22, 0, 0, 40), bench.item(2, 16, 300, 0, 60));
        bench.command(176, 1, AUTO);
        bench.command(400, 1);
        bench.run(40);
        assertThat(bench.mode()).isEqualTo(RTL);
        bench.heard.clear();
        bench.command(176, 1, AUTO);
        bench.run(1);
        assertThat(bench.texts()).contains("Mission: 1 Takeoff", "Mission: 2 WP");
    }

    @Test
    void forcedToDisarmItGlidesDown() {
        VehicleTestBench bench = flying(PLANE);
        assertThat(bench.command(400, 0)).isEqualTo(4);
        assertThat(bench.command(400, 0, 21196)).isZero();
        bench.run(70);
        assertThat(bench.height()).isZero();
        assertThat(bench.vehicle.autopilot().landedState()).isOne();
    }
}
