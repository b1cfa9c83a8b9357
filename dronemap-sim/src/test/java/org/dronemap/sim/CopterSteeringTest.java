package org.dronemap.sim;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.mavlink.message.ManualControl;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.mavlink.message.SetPositionTargetLocalNed;
import org.dronemap.sim.physics.LocalFrame;
import org.dronemap.sim.physics.NeuPosition;
import org.dronemap.sim.physics.VehicleBody;
import org.junit.jupiter.api.Test;

/** An ArduCopter that is steered by speeds and led by places in GUIDED, and by a ground station's sticks in LOITER. */
class CopterSteeringTest {
    private static final int LOITER = 5;
    private static final int NORTH_FRAME = 1;
    private static final int NOSE_FRAME = 8;
    private static final int RELATIVE_FRAME = 6;
    private static final int PLACE_AND_SPEED = 0xDC0;
    private static final int SPEEDS = 0xDC7;
    private static final int SPEEDS_AND_TURN = 0x5C7;

    private final VehicleTestBench bench = VehicleTestBench.flying(20);
    private final VehicleBody body = bench.vehicle.craft().body();

    @Test
    void fliesWithTheSpeedThatItIsToldAndStopsThreeSecondsAfterTheLast() {
        drive(NORTH_FRAME, SPEEDS, 3, 0, 0);
        bench.run(2.5);
        assertThat(body.groundSpeed()).isBetween(2.5, 3.5);
        double north = body.position().north();
        assertThat(north).isGreaterThan(2);
        bench.run(6);
        assertThat(body.groundSpeed()).isLessThan(0.3);
    }

    @Test
    void standsWhenItIsToldNoSpeed() {
        drive(NORTH_FRAME, SPEEDS, 3, 0, 0);
        bench.run(2);
        drive(NORTH_FRAME, SPEEDS, 0, 0, 0);
        bench.run(2);
        assertThat(body.groundSpeed()).isLessThan(0.3);
    }

    @Test
    void countsForwardFromItsNoseAndTurns() {
        for (int tenth = 0; tenth < 20; tenth++) {
            drive(NOSE_FRAME, SPEEDS_AND_TURN, 0, 0, (float) (Math.PI / 4));
            bench.run(0.1);
        }
        double looks = body.yaw();
        assertThat(Math.abs(looks)).isGreaterThan(0.5);
        drive(NOSE_FRAME, SPEEDS, 4, 0, 0);
        double north = body.position().north();
        double east = body.position().east();
        bench.run(2.5);
        double course =
                Math.atan2(body.position().east() - east, body.position().north() - north);
        assertThat(Math.IEEEremainder(course - body.yaw(), 2 * Math.PI)).isBetween(-0.2, 0.2);
    }

    @Test
    void heedsSticksInLoiterOnlyAndStaysWhereTheHandsLeftIt() {
        sticks(1000, 0, 500);
        bench.run(2);
        assertThat(body.groundSpeed()).isLessThan(0.3);

        bench.command(176, 1, LOITER);
        for (int tenth = 0; tenth < 30; tenth++) {
            sticks(500, 0, 750);
            bench.run(0.1);
        }
        assertThat(body.groundSpeed()).isGreaterThan(3);
        assertThat(bench.height()).isGreaterThan(21);
        sticks(0, 0, 500);
        bench.run(8);
        assertThat(body.groundSpeed()).isLessThan(0.3);
        double north = body.position().north();
        bench.run(5);
        assertThat(body.position().north()).isBetween(north - 1, north + 1);
    }

    @Test
    void keepsUpWithAPlaceThatMovesAndStaysWhereItWasThreeSecondsAfterTheLast() {
        double north = body.position().north();
        for (int second = 0; second < 20; second++) {
            lead(north + 4 * second, 4);
            bench.run(1);
        }
        assertThat(body.position().north()).isBetween(north + 79, north + 81);
        bench.run(12);
        assertThat(body.groundSpeed()).isLessThan(0.3);
        assertThat(body.position().north()).isBetween(north + 87, north + 89);
    }

    private void lead(double north, float speed) {
        LocalFrame home = bench.vehicle.craft().home();
        NeuPosition place = new NeuPosition(north, body.position().east(), 20);
        bench.send(new SetPositionTargetGlobalInt(
                0,
                1,
                1,
                RELATIVE_FRAME,
                PLACE_AND_SPEED,
                (int) Math.round(home.latitudeOf(place) * 1e7),
                (int) Math.round(home.longitudeOf(place) * 1e7),
                20,
                speed,
                0,
                0,
                0,
                0,
                0,
                0,
                0));
    }

    private void drive(int frame, int mask, float forward, float right, float turn) {
        bench.send(new SetPositionTargetLocalNed(0, 1, 1, frame, mask, 0, 0, 0, forward, right, 0, 0, 0, 0, 0, turn));
    }

    private void sticks(int x, int y, int z) {
        bench.send(new ManualControl(1, x, y, z, 0, 0, 0, 0, 0, 0));
    }
}
