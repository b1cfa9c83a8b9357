package org.dronemap.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.sim.control.SimulatorControlCommands;
import org.junit.jupiter.api.Test;

class FaultsTest {
    private static void fault(VehicleTestBench bench, String what) {
        assertThat(SimulatorControlCommands.run("fault 1 " + what, List.of(bench.vehicle)))
                .startsWith("ok");
    }

    @Test
    void silentStopsTalkingAndListening() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        fault(bench, "silent 10s");
        bench.run(9);
        assertThat(bench.heard).isEmpty();
        assertThat(bench.command(400, 1)).isEqualTo(-1);
        bench.run(3);
        assertThat(bench.heard).isNotEmpty();
        assertThat(bench.height()).isBetween(19.0, 21.0);
    }

    @Test
    void whoIsWokenTalksAtOnceAndMakesUpForNothing() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        fault(bench, "silent 10000s");
        bench.run(100);
        assertThat(bench.heard).isEmpty();
        assertThat(SimulatorControlCommands.run("wake 1", List.of(bench.vehicle)))
                .isEqualTo("ok 1 vehicles");
        bench.run(2);
        assertThat(bench.heard.stream().filter(heard -> heard.frame().messageId() == Heartbeat.ID))
                .hasSizeBetween(1, 3);
        assertThat(SimulatorControlCommands.run("wake 2", List.of(bench.vehicle)))
                .startsWith("err");
    }

    @Test
    void gpsOffMakesItLand() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        fault(bench, "gps off");
        bench.run(9);
        assertThat(bench.mode()).isEqualTo(9);
        fault(bench, "gps on");
        bench.run(3);
        assertThat(bench.texts()).contains("EKF Failsafe Cleared");
    }

    @Test
    void batterySetsWhatIsLeft() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        fault(bench, "battery 15");
        assertThat(bench.vehicle.craft().battery().remainingPercent()).isBetween(14.9, 15.1);
    }

    @Test
    void anEmptyBatteryMakesItFall() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        fault(bench, "battery 0");
        bench.run(4);
        assertThat(bench.height()).isZero();
    }

    @Test
    void crashFallsAndDoesNotArmAgainUntilRepaired() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        fault(bench, "crash");
        bench.run(5);
        assertThat(bench.height()).isZero();
        bench.command(400, 0, 21196);
        assertThat(bench.command(400, 1)).isEqualTo(4);
        fault(bench, "repair");
        bench.run(3);
        assertThat(bench.command(400, 1)).isZero();
    }

    @Test
    void motorFailureFallsAndStaysArmed() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        fault(bench, "motor-failure");
        bench.run(10);
        assertThat(bench.height()).isZero();
        assertThat(bench.armed()).isTrue();
    }

    @Test
    void rebootForgetsTheModeAndKeepsMissionAndParameters() {
        VehicleTestBench bench = VehicleTestBench.ready();
        bench.parameter("RTL_ALT", 2000);
        bench.upload(bench.item(0, 16, 0, 0, 0), bench.item(1, 22, 0, 0, 20));
        bench.command(176, 1, 4);
        fault(bench, "reboot");
        assertThat(bench.mode()).isZero();
        assertThat(bench.vehicle.autopilot().parameters().value("RTL_ALT")).isEqualTo(2000);
        assertThat(bench.vehicle.autopilot().plan().size()).isEqualTo(2);
        bench.run(2);
        assertThat(bench.command(400, 1)).isEqualTo(4);
        bench.run(6);
        assertThat(bench.command(400, 1)).isZero();
    }

    @Test
    void aDeafVehicleGoesOnTalkingAndItsFailsafeActs() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        bench.parameter("FS_GCS_ENABLE", 1);
        fault(bench, "gcs-ignore on");
        assertThat(bench.command(400, 1)).isEqualTo(-1);
        bench.run(6.1);
        assertThat(bench.heard).isNotEmpty();
        assertThat(bench.mode()).isEqualTo(6);
    }

    @Test
    void stickLowSinksInLoiter() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        bench.command(176, 1, 5);
        fault(bench, "stick low");
        bench.run(4);
        assertThat(bench.height()).isLessThan(14);
    }
}
