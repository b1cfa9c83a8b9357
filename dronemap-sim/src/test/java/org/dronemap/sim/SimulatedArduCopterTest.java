package org.dronemap.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Set;
import org.dronemap.mavlink.message.AutopilotVersion;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.HomePosition;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionCurrent;
import org.dronemap.mavlink.message.MissionItemReached;
import org.dronemap.mavlink.message.Timesync;
import org.junit.jupiter.api.Test;

class SimulatedArduCopterTest {
    private static final int GUIDED = 4;
    private static final int AUTO = 3;
    private static final int LOITER = 5;
    private static final int RTL = 6;
    private static final int LAND = 9;

    @Test
    void saysOnlyHeartbeatTimesyncAndHomeUntilAsked() {
        VehicleTestBench bench = new VehicleTestBench();
        bench.run(5);
        assertThat(bench.heard)
                .isNotEmpty()
                .allMatch(h -> Set.of(Heartbeat.ID, Timesync.ID, HomePosition.ID)
                        .contains(h.frame().messageId()));
        assertThat(bench.count(HomePosition.ID)).isOne();
        assertThat(bench.command(511, GlobalPositionInt.ID, 250_000)).isZero();
        bench.run(5);
        assertThat(bench.count(GlobalPositionInt.ID)).isBetween(19L, 21L);
    }

    @Test
    void tellsItsVersionAndAnIdOfItsOwn() {
        VehicleTestBench bench = VehicleTestBench.ready("--sysid", "7");
        bench.send(new org.dronemap.mavlink.message.CommandLong(7, 1, 512, 0, 148, 0, 0, 0, 0, 0, 0));
        AutopilotVersion version = AutopilotVersion.decode(bench.heard.get(1).frame());
        assertThat(version.flightSwVersion() >> 24).isEqualTo(4);
        assertThat(version.uid() & 0xFF).isEqualTo(7);
    }

    @Test
    void refusesToArmBeforeItKnowsWhereItIs() {
        VehicleTestBench bench = new VehicleTestBench("--ready-after", "20");
        assertThat(bench.command(176, 1, 4)).isZero();
        for (int seconds : new int[] {2, 6, 6}) {
            bench.run(seconds);
            assertThat(bench.command(400, 1)).isEqualTo(4);
        }
        assertThat(bench.texts())
                .contains(
                        "Arm: Need Alt Estimate",
                        "Arm: EKF attitude is bad",
                        "Arm: AHRS: waiting for home",
                        "Arm: Need Position Estimate");
        bench.run(8);
        assertThat(bench.command(400, 1)).isZero();
    }

    @Test
    void refusesToArmWhenBatteryIsLow() {
        VehicleTestBench bench = VehicleTestBench.ready();
        bench.vehicle.craft().battery().setRemainingPercent(4);
        assertThat(bench.command(400, 1)).isEqualTo(4);
        assertThat(bench.texts()).contains("Arm: Battery 1 low voltage failsafe");
    }

    @Test
    void takesOffOnlyWhenArmedInGuided() {
        VehicleTestBench bench = VehicleTestBench.ready();
        assertThat(bench.command(22, 0, 0, 0, 0, 0, 0, 10)).isEqualTo(4);
        bench.command(400, 1);
        assertThat(bench.command(22, 0, 0, 0, 0, 0, 0, 10)).isEqualTo(4);
        bench.command(176, 1, GUIDED);
        assertThat(bench.command(22, 0, 0, 0, 0, 0, 0, 10)).isZero();
        bench.run(12);
        assertThat(bench.height()).isBetween(9.5, 10.5);
    }

    @Test
    void disarmsByItselfWhenItDoesNotTakeOff() {
        VehicleTestBench bench = VehicleTestBench.ready();
        bench.command(400, 1);
        bench.run(9.5);
        assertThat(bench.armed()).isTrue();
        bench.run(1);
        assertThat(bench.armed()).isFalse();
    }

    @Test
    void staysArmedOnTheGroundForAsLongAsItWasStartedTo() {
        VehicleTestBench bench = VehicleTestBench.ready("--parameter", "DISARM_DELAY=120");
        bench.command(400, 1);
        bench.run(119.5);
        assertThat(bench.armed()).isTrue();
        bench.run(1);
        assertThat(bench.armed()).isFalse();
    }

    @Test
    void isNotStartedWithAParameterThatItDoesNotHave() {
        assertThatThrownBy(() -> VehicleTestBench.ready("--parameter", "NOBODY_KNOWS=1"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("this autopilot has no parameter 'NOBODY_KNOWS'");
        assertThatThrownBy(() -> SimulatorOptions.parse(List.of("--parameter", "DISARM_DELAY")))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("--parameter wants NAME=VALUE, not 'DISARM_DELAY'");
    }

    @Test
    void refusesToDisarmInFlightExceptByForce() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        assertThat(bench.command(400, 0)).isEqualTo(4);
        assertThat(bench.armed()).isTrue();
        assertThat(bench.command(400, 0, 21196)).isZero();
        bench.run(4);
        assertThat(bench.height()).isZero();
    }

    @Test
    void actsOnEveryCopyOfAnOrder() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        double before = Math.toDegrees(bench.vehicle.craft().body().yaw());
        for (int i = 0; i < 3; i++) {
            assertThat(bench.command(115, 30, 20, 1, 1)).isZero();
            bench.run(4);
        }
        double turned = Math.toDegrees(bench.vehicle.craft().body().yaw()) - before;
        assertThat(turned).isBetween(88.0, 92.0);
    }

    @Test
    void fliesAMissionFromTheGroundToItsEnd() {
        VehicleTestBench bench = VehicleTestBench.ready("--wind", "5");
        bench.upload(
                bench.item(0, 16, 0, 0, 0),
                bench.item(1, 22, 0, 0, 20),
                bench.item(2, 16, 40, 0, 20),
                bench.item(3, 16, 40, 40, 25),
                bench.item(4, 20, 0, 0, 0));
        assertThat(MissionAck.decode(last(bench, MissionAck.ID)).type()).isZero();
        bench.command(176, 1, GUIDED);
        bench.command(400, 1);
        assertThat(bench.command(300)).isZero();
        bench.run(120);
        assertThat(bench.count(MissionItemReached.ID)).isEqualTo(4);
        assertThat(bench.armed()).isFalse();
        assertThat(bench.mode()).isEqualTo(AUTO);
        assertThat(bench.vehicle
                        .craft()
                        .body()
                        .position()
                        .horizontalDistanceTo(bench.vehicle.craft().homePosition()))
                .isLessThan(2);
    }

    private static org.dronemap.mavlink.Frame last(VehicleTestBench bench, int id) {
        return bench.heard.stream()
                .filter(h -> h.frame().messageId() == id)
                .reduce((a, b) -> b)
                .orElseThrow()
                .frame();
    }

    @Test
    void overwritesItsMissionItemByItem() {
        VehicleTestBench bench = VehicleTestBench.ready();
        bench.upload(bench.item(0, 16, 0, 0, 0), bench.item(1, 22, 0, 0, 20), bench.item(2, 16, 40, 0, 20));
        bench.send(new org.dronemap.mavlink.message.MissionCount(1, 1, 3, 0));
        bench.send(bench.item(0, 16, 0, 0, 0));
        bench.send(bench.item(1, 22, 0, 0, 50));
        bench.run(9);
        assertThat(bench.texts()).contains("Mission upload timeout");
        assertThat(bench.vehicle.autopilot().plan().item(1).z()).isEqualTo(50f);
        assertThat(bench.vehicle.autopilot().plan().item(2).z()).isEqualTo(20f);
    }

    @Test
    void refusesAutoInFlightWithoutAMission() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        assertThat(bench.command(176, 1, AUTO)).isEqualTo(4);
        assertThat(bench.texts()).contains("Mode change to AUTO failed: init failed");
    }

    @Test
    void returnsWhenBatteryIsLowIfToldTo() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        bench.parameter("BATT_FS_LOW_ACT", 2);
        bench.vehicle.craft().battery().setRemainingPercent(4);
        bench.run(11);
        assertThat(bench.mode()).isEqualTo(RTL);
        assertThat(bench.texts()).contains("Battery Failsafe");
    }

    @Test
    void onlyWarnsOfALowBatteryByDefault() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        bench.vehicle.craft().battery().setRemainingPercent(4);
        bench.run(11);
        assertThat(bench.mode()).isEqualTo(GUIDED);
        assertThat(bench.beat().systemStatus()).isEqualTo(5);
    }

    @Test
    void returnsWhenTheGroundStationIsLostIfToldTo() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        bench.parameter("FS_GCS_ENABLE", 1);
        bench.groundTalks(false);
        bench.run(6.1);
        assertThat(bench.mode()).isEqualTo(RTL);
        bench.groundTalks(true);
        bench.run(2);
        assertThat(bench.mode()).isEqualTo(RTL);
        assertThat(bench.texts()).contains("GCS Failsafe", "GCS Failsafe Cleared");
    }

    @Test
    void fliesOnWithoutAGroundStationByDefault() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        bench.groundTalks(false);
        bench.run(30);
        assertThat(bench.mode()).isEqualTo(GUIDED);
    }

    @Test
    void landsWhenGpsIsLostAndStaysInLand() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        bench.vehicle.craft().navigation().setReceiving(false);
        bench.run(7.5);
        assertThat(bench.mode()).isEqualTo(GUIDED);
        bench.run(1);
        assertThat(bench.mode()).isEqualTo(LAND);
        bench.vehicle.craft().navigation().setReceiving(true);
        bench.run(3);
        assertThat(bench.mode()).isEqualTo(LAND);
        assertThat(bench.texts()).contains("EKF Failsafe: changed to LAND Mode", "EKF Failsafe Cleared");
    }

    @Test
    void fallsAndStaysArmedWhenAMotorFails() {
        VehicleTestBench bench = VehicleTestBench.flying(40);
        bench.vehicle.craft().failMotor();
        bench.run(3);
        assertThat(bench.vehicle.craft().body().velocityUp()).isLessThan(-11);
        bench.run(60);
        assertThat(bench.armed()).isTrue();
        assertThat(bench.height()).isZero();
        assertThat(bench.texts()).contains("Potential Thrust Loss (1)");
    }

    @Test
    void sinksInLoiterWhenTheThrottleStickIsLow() {
        VehicleTestBench held = VehicleTestBench.flying(20);
        held.command(176, 1, LOITER);
        held.run(5);
        assertThat(held.height()).isBetween(19.0, 21.0);
        VehicleTestBench sinking = VehicleTestBench.flying(20, "--stick", "low");
        sinking.command(176, 1, LOITER);
        sinking.run(5);
        assertThat(sinking.height()).isLessThan(12);
    }

    @Test
    void fliesTheSameWithTheSameSeed() {
        double[] places = new double[3];
        for (int i = 0; i < 3; i++) {
            VehicleTestBench bench = VehicleTestBench.flying(20, "--wind", "8", "--seed", i == 2 ? "6" : "5");
            bench.run(20);
            places[i] = bench.vehicle.craft().body().position().north();
        }
        assertThat(places[0]).isEqualTo(places[1]);
        assertThat(places[0]).isNotEqualTo(places[2]);
    }

    @Test
    void countsItsMissionWithoutHome() {
        VehicleTestBench bench = VehicleTestBench.ready();
        bench.upload(bench.item(0, 16, 0, 0, 0), bench.item(1, 22, 0, 0, 20));
        bench.command(512, MissionCurrent.ID);
        assertThat(MissionCurrent.decode(last(bench, MissionCurrent.ID)).total())
                .isEqualTo(1);
    }
}
