package org.dronemap.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.dronemap.mavlink.message.FenceStatus;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.physics.NeuPosition;
import org.junit.jupiter.api.Test;

class FenceOnBoardTest {
    private static final int FENCE = 1;
    private static final int INCLUSION = 5001;
    private static final int EXCLUDED_CIRCLE = 5004;
    private static final int GUIDED = 4;
    private static final int LAND = 9;
    private static final int BRAKE = 17;

    private static MissionItemInt item(VehicleTestBench bench, int seq, int command, float first, int[] place) {
        var home = bench.vehicle.craft().home();
        NeuPosition there = new NeuPosition(place[0], place[1], 0);
        int latitude = (int) Math.round(home.latitudeOf(there) * 1e7);
        int longitude = (int) Math.round(home.longitudeOf(there) * 1e7);
        return new MissionItemInt(1, 1, seq, 0, command, 0, 1, first, 0, 0, 0, latitude, longitude, 0, FENCE);
    }

    /** A square of 200 m around home with a hole of 20 m in the north. */
    private static void uploadSquareWithHole(VehicleTestBench bench) {
        int[][] corners = {{100, 100}, {100, -100}, {-100, -100}, {-100, 100}};
        bench.send(new MissionCount(1, 1, corners.length + 1, FENCE));
        for (int i = 0; i < corners.length; i++) {
            bench.send(item(bench, i, INCLUSION, corners.length, corners[i]));
        }
        bench.send(item(bench, corners.length, EXCLUDED_CIRCLE, 20, new int[] {60, 0}));
        assertThat(bench.last(MissionAck.ID, MissionAck::decode).type()).isZero();
        bench.parameter("FENCE_TYPE", 4);
        bench.parameter("FENCE_ENABLE", 1);
    }

    private static void goTo(VehicleTestBench bench, double north, double east) {
        SimulatedCraft craft = bench.vehicle.craft();
        NeuPosition there = new NeuPosition(north, east, 0);
        int latitude = (int) Math.round(craft.home().latitudeOf(there) * 1e7);
        int longitude = (int) Math.round(craft.home().longitudeOf(there) * 1e7);
        bench.send(new SetPositionTargetGlobalInt(0, 1, 1, 6, 3576, latitude, longitude, 20, 0, 0, 0, 0, 0, 0, 0, 0));
        bench.run(25);
    }

    private static double north(VehicleTestBench bench) {
        return bench.vehicle.craft().body().position().north();
    }

    @Test
    void fliesInsideItsPolygonAndNotIntoAHoleOrOut() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        uploadSquareWithHole(bench);
        goTo(bench, 60, 5);
        assertThat(north(bench)).as("into the hole").isBetween(-1.0, 1.0);
        goTo(bench, 150, 0);
        assertThat(north(bench)).as("out").isBetween(-1.0, 1.0);
        goTo(bench, -60, 0);
        assertThat(north(bench)).as("inside").isBetween(-61.0, -59.0);
        assertThat(bench.mode()).isEqualTo(GUIDED);
        bench.command(512, FenceStatus.ID);
        assertThat(bench.last(FenceStatus.ID, FenceStatus::decode).breachStatus())
                .isZero();
    }

    @Test
    void doesAfterABreachWhatItsActionSays() {
        for (int[] actionAndMode : new int[][] {{0, GUIDED}, {2, LAND}, {4, BRAKE}}) {
            VehicleTestBench bench = VehicleTestBench.flying(20, "--parameter", "FENCE_ACTION=" + actionAndMode[0]);
            bench.parameter("FENCE_RADIUS", 300);
            bench.parameter("FENCE_ALT_MAX", 19);
            bench.parameter("FENCE_ENABLE", 1);
            bench.run(1);
            assertThat(bench.texts()).contains("Fence Breached");
            assertThat(bench.mode()).as("FENCE_ACTION " + actionAndMode[0]).isEqualTo(actionAndMode[1]);
        }
    }

    @Test
    void landsWhenItIsMoreThanAHundredMetersOutside() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        goTo(bench, 150, 0);
        bench.parameter("FENCE_RADIUS", 30);
        bench.parameter("FENCE_ENABLE", 1);
        bench.run(1);
        assertThat(bench.mode()).isEqualTo(LAND);
    }

    @Test
    void selectsByDefaultWhatItsKindCanHeed() {
        Map<String, Integer> types = Map.of("arducopter", 7, "ardurover", 6, "arduplane", 4, "quadplane", 4);
        types.forEach((kind, type) -> assertThat(VehicleTestBench.ready("--personality", kind)
                        .vehicle
                        .autopilot()
                        .parameters()
                        .value("FENCE_TYPE"))
                .as(kind)
                .isEqualTo(type.doubleValue()));
    }

    @Test
    void keepsItsFenceOverAReboot() {
        VehicleTestBench bench = VehicleTestBench.ready();
        uploadSquareWithHole(bench);
        bench.vehicle.reboot();
        bench.run(10);
        assertThat(bench.vehicle.autopilot().fence().items()).hasSize(5);
        assertThat(bench.texts()).containsOnlyOnce("Fence Indexed OK");
        assertThat(bench.vehicle.autopilot().parameters().value("FENCE_ENABLE")).isEqualTo(1);
    }
}
