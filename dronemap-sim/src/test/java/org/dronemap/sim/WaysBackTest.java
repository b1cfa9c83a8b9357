package org.dronemap.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.sim.physics.NeuPosition;
import org.junit.jupiter.api.Test;

/** The places that simulated ArduPilots come back to, and the ways that they take there. */
class WaysBackTest {
    private static final int RALLY = 2;
    private static final int RALLY_POINT = 5100;
    private static final int SMART_RTL = 21;
    private static final int RTL = 6;

    private static NeuPosition here(VehicleTestBench bench) {
        return bench.vehicle.craft().body().position();
    }

    private static int[] place(VehicleTestBench bench, double north, double east) {
        var home = bench.vehicle.craft().home();
        NeuPosition there = new NeuPosition(north, east, 0);
        return new int[] {
            (int) Math.round(home.latitudeOf(there) * 1e7), (int) Math.round(home.longitudeOf(there) * 1e7)
        };
    }

    private static void goTo(VehicleTestBench bench, double north, double east) {
        int[] there = place(bench, north, east);
        bench.send(new SetPositionTargetGlobalInt(0, 1, 1, 6, 3576, there[0], there[1], 20, 0, 0, 0, 0, 0, 0, 0, 0));
        bench.run(20);
    }

    private static void rallyPoint(VehicleTestBench bench, double north, double east) {
        int[] there = place(bench, north, east);
        bench.send(new MissionCount(1, 1, 1, RALLY));
        bench.send(new MissionItemInt(1, 1, 0, 3, RALLY_POINT, 0, 1, 0, 0, 0, 0, there[0], there[1], 25, RALLY));
    }

    private static double mostEast(VehicleTestBench bench) {
        double most = here(bench).east();
        for (int seconds = 0; seconds < 150 && bench.armed(); seconds++) {
            bench.run(1);
            most = Math.max(most, here(bench).east());
        }
        assertThat(bench.armed()).as("it is down").isFalse();
        return most;
    }

    @Test
    void aLoopIsLeftOutOnTheWayBack() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        goTo(bench, 60, 0);
        goTo(bench, 60, 60);
        goTo(bench, 30, 30);
        goTo(bench, 30, 0);
        bench.command(176, 1, SMART_RTL);
        assertThat(mostEast(bench)).as("not round by the east again").isLessThan(5);
        assertThat(here(bench).horizontalDistanceTo(bench.vehicle.craft().homePosition()))
                .isLessThan(1);
    }

    @Test
    void theWayBackIsTheWayOutWhereItIsNoLoop() {
        VehicleTestBench bench = VehicleTestBench.flying(20);
        goTo(bench, 0, 60);
        goTo(bench, 60, 60);
        goTo(bench, 60, 0);
        bench.command(176, 1, SMART_RTL);
        assertThat(mostEast(bench)).as("round by the east").isGreaterThan(55);
        assertThat(here(bench).horizontalDistanceTo(bench.vehicle.craft().homePosition()))
                .isLessThan(1);
    }

    @Test
    void aRallyPointCountsWhereItIsNearerThanHomeAndNotTooFarAway() {
        for (double[] limitAndEast : new double[][] {{0.3, 80}, {0.01, 0}}) {
            VehicleTestBench bench = VehicleTestBench.flying(20, "--parameter", "RALLY_LIMIT_KM=" + limitAndEast[0]);
            rallyPoint(bench, 0, 80);
            goTo(bench, 0, 50);
            bench.command(176, 1, RTL);
            mostEast(bench);
            assertThat(here(bench).east()).isCloseTo(limitAndEast[1], within(1.5));
        }
        VehicleTestBench bench = VehicleTestBench.flying(20);
        rallyPoint(bench, 0, 80);
        goTo(bench, 0, 30);
        bench.command(176, 1, RTL);
        mostEast(bench);
        assertThat(here(bench).east()).as("home is nearer").isBetween(-1.5, 1.5);
    }
}
