package org.dronemap.sim;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.sim.physics.VehicleBody;
import org.junit.jupiter.api.Test;

/** What the recordings do not show of the simulated QuadPlane. */
class SimulatedQuadPlaneTest {
    private static final int GUIDED = 15;
    private static final int QLOITER = 19;
    private static final int QLAND = 20;
    private static final int QRTL = 21;

    private static VehicleTestBench hovering(String... more) {
        String[] options = new String[more.length + 2];
        options[0] = "--personality";
        options[1] = "quadplane";
        System.arraycopy(more, 0, options, 2, more.length);
        VehicleTestBench bench = VehicleTestBench.ready(options);
        bench.command(176, 1, GUIDED);
        bench.command(400, 1);
        assertThat(bench.command(22, 0, 0, 0, 0, 0, 0, 30)).isZero();
        bench.run(25);
        bench.heard.clear();
        return bench;
    }

    @Test
    void hoversWhereItTookOffUntilItIsSentSomewhere() {
        VehicleTestBench bench = hovering("--wind", "5");
        bench.run(30);
        VehicleBody body = bench.vehicle.craft().body();
        assertThat(body.groundSpeed()).isLessThan(2);
        assertThat(bench.height()).isBetween(28.0, 32.0);
        assertThat(body.position().horizontalDistanceTo(bench.vehicle.craft().homePosition()))
                .isLessThan(5);
    }

    @Test
    void holdsInQloiterWithItsStickInTheMiddle() {
        VehicleTestBench bench = hovering();
        assertThat(bench.command(176, 1, QLOITER)).isZero();
        bench.run(20);
        assertThat(bench.height()).isBetween(28.0, 32.0);
        assertThat(bench.vehicle.autopilot().vtolState()).isEqualTo(3);
    }

    @Test
    void losesItsLiftWhenItIsForcedToDisarm() {
        VehicleTestBench bench = hovering();
        assertThat(bench.command(400, 0)).isEqualTo(4);
        assertThat(bench.command(400, 0, 21196)).isZero();
        bench.run(10);
        assertThat(bench.height()).isZero();
        assertThat(bench.vehicle.craft().crashed()).isTrue();
    }

    @Test
    void landsWhereItIsAndMayTakeOffAgain() {
        VehicleTestBench bench = hovering();
        bench.command(176, 1, QLAND);
        bench.run(60);
        assertThat(bench.armed()).isFalse();
        assertThat(bench.texts()).contains("Land complete", "Throttle disarmed");
        bench.command(176, 1, GUIDED);
        assertThat(bench.command(400, 1)).isZero();
        assertThat(bench.command(22, 0, 0, 0, 0, 0, 0, 10)).isZero();
        bench.run(15);
        assertThat(bench.height()).isBetween(9.0, 11.0);
        assertThat(bench.command(22, 0, 0, 0, 0, 0, 0, 20)).isEqualTo(4);
        assertThat(bench.texts()).contains("Already flying - no takeoff");
    }

    @Test
    void comesHomeFromAHoverByQrtl() {
        VehicleTestBench bench = hovering();
        bench.command(176, 1, QRTL);
        bench.run(60);
        assertThat(bench.armed()).isFalse();
        assertThat(bench.mode()).isEqualTo(QRTL);
        assertThat(bench.texts()).contains("Land descend started", "Land final started", "Land complete");
    }

    @Test
    void landsInsteadOfReturningWhenTheGroundStationIsLostInQloiter() {
        VehicleTestBench bench = hovering("--parameter", "FS_GCS_ENABL=1", "--parameter", "FS_LONG_ACTN=1");
        bench.command(176, 1, QLOITER);
        bench.groundTalks(false);
        bench.run(8);
        assertThat(bench.mode()).isEqualTo(QLAND);
    }
}
