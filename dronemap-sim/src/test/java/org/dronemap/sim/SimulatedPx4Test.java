package org.dronemap.sim;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.MissionItemReached;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.junit.jupiter.api.Test;

class SimulatedPx4Test {
    private static final long HOLD = 4L << 16 | 3L << 24;
    private static final long MISSION = 4L << 16 | 4L << 24;
    private static final long RETURN = 4L << 16 | 5L << 24;
    private static final long LAND = 4L << 16 | 6L << 24;

    private static VehicleTestBench flying() {
        VehicleTestBench bench = VehicleTestBench.ready("--personality", "px4");
        assertThat(bench.command(22, 0, 0, 0, 0, 0, 0, 508)).isZero();
        assertThat(bench.command(400, 1)).isZero();
        bench.run(25);
        bench.heard.clear();
        return bench;
    }

    @Test
    void takesOffToAnAltitudeAboveTheSeaAndThenHolds() {
        VehicleTestBench bench = flying();
        assertThat(bench.height()).isBetween(19.0, 21.0);
        assertThat(bench.mode()).isEqualTo(HOLD);
    }

    @Test
    void knowsNoGuidedMode() {
        VehicleTestBench bench = flying();
        assertThat(bench.command(176, 1, 4)).isNotZero();
        assertThat(bench.mode()).isEqualTo(HOLD);
    }

    @Test
    void ignoresPositionTargetsButRepositions() {
        VehicleTestBench bench = flying();
        var home = bench.vehicle.craft().home();
        int north = (int) Math.round(home.latitude() * 1e7) + 4_000;
        int east = (int) Math.round(home.longitude() * 1e7);
        bench.send(new SetPositionTargetGlobalInt(0, 1, 1, 6, 3576, north, east, 20, 0, 0, 0, 0, 0, 0, 0, 0));
        bench.run(10);
        assertThat(bench.vehicle.craft().body().position().north()).isBetween(-1.0, 1.0);
        float nan = Float.NaN;
        bench.send(new org.dronemap.mavlink.message.CommandInt(1, 1, 5, 192, 0, 0, -1, 1, 0, nan, north, east, 518));
        bench.run(25);
        assertThat(bench.vehicle.craft().body().position().north()).isBetween(43.0, 46.0);
        assertThat(bench.height()).isBetween(29.0, 31.0);
    }

    @Test
    void startsAMissionWithItsFirstItemAndArmsForIt() {
        VehicleTestBench bench = VehicleTestBench.ready("--personality", "px4");
        bench.upload(bench.item(0, 22, 0, 0, 20), bench.item(1, 16, 40, 0, 20), bench.item(2, 20, 0, 0, 0));
        assertThat(bench.command(300)).isZero();
        assertThat(bench.mode()).isEqualTo(MISSION);
        bench.run(200);
        assertThat(bench.count(MissionItemReached.ID)).isEqualTo(3);
        assertThat(bench.armed()).isFalse();
    }

    @Test
    void keepsTheOldMissionUntilTheNewOneIsWhole() {
        VehicleTestBench bench = VehicleTestBench.ready("--personality", "px4");
        bench.upload(bench.item(0, 22, 0, 0, 20), bench.item(1, 16, 40, 0, 20));
        bench.send(new org.dronemap.mavlink.message.MissionCount(1, 1, 2, 0));
        bench.send(bench.item(0, 22, 0, 0, 50));
        bench.run(6);
        assertThat(bench.vehicle.autopilot().plan().item(0).z()).isEqualTo(20f);
    }

    @Test
    void deniesAMissionThatIsNotThere() {
        VehicleTestBench bench = VehicleTestBench.ready("--personality", "px4");
        assertThat(bench.command(300)).isEqualTo(2);
    }

    @Test
    void returnsWhenTheDataLinkIsLostIfToldTo() {
        VehicleTestBench bench = flying();
        bench.vehicle.autopilot().parameters().set("NAV_DLL_ACT", 2);
        bench.groundTalks(false);
        bench.run(11.1);
        assertThat(bench.mode()).isEqualTo(RETURN);
    }

    @Test
    void landsWhenThePositionIsLost() {
        VehicleTestBench bench = flying();
        bench.vehicle.craft().navigation().setReceiving(false);
        bench.run(9);
        assertThat(bench.mode()).isEqualTo(LAND);
    }

    @Test
    void returnsWhenTheBatteryIsCriticalIfToldTo() {
        VehicleTestBench bench = flying();
        bench.vehicle.autopilot().parameters().set("COM_LOW_BAT_ACT", 3);
        bench.vehicle.craft().battery().setRemainingPercent(6);
        bench.run(1);
        assertThat(bench.mode()).isEqualTo(RETURN);
    }

    @Test
    void temporarilyRejectsArmingBeforeItIsReady() {
        VehicleTestBench bench = new VehicleTestBench("--personality", "px4", "--ready-after", "30");
        bench.run(1);
        bench.send(new CommandLong(1, 1, 400, 0, 1, 0, 0, 0, 0, 0, 0));
        assertThat(bench.texts()).contains("Preflight Fail: GPS fix too low");
        assertThat(bench.armed()).isFalse();
    }
}
