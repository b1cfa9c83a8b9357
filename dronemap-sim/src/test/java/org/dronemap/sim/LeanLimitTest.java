package org.dronemap.sim;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.sim.physics.Airframe;
import org.dronemap.sim.physics.MotionSetpoint;
import org.dronemap.sim.physics.MulticopterBody;
import org.dronemap.sim.physics.NeuPosition;
import org.dronemap.sim.physics.WindModel;
import org.junit.jupiter.api.Test;

/** A copter that leans no farther than a real ArduCopter, beside a place that moves. */
class LeanLimitTest {
    private static final double STEP = 0.02;
    private static final double UP = 20;

    private final MulticopterBody body = new MulticopterBody(Airframe.leaning(30), 0);
    private double north;
    private double east;

    private void rise(WindModel wind) {
        for (double now = 0; now < 40; now += STEP) {
            body.step(new MotionSetpoint.Reach(new NeuPosition(0, 0, UP), 10, 2, 2, 0), wind, STEP);
        }
    }

    /** The place moves on with that velocity. */
    private void led(double northward, double eastward, double seconds, WindModel wind) {
        for (double now = 0; now < seconds; now += STEP) {
            north += northward * STEP;
            east += eastward * STEP;
            MotionSetpoint.Reach place = new MotionSetpoint.Reach(new NeuPosition(north, east, UP), 15, 2, 2, 0);
            body.step(new MotionSetpoint.Track(place, northward, eastward, 0), wind, STEP);
            wind.step(STEP);
        }
    }

    private double off() {
        return Math.hypot(body.position().north() - north, body.position().east() - east);
    }

    @Test
    void keepsUpAndTurnsWithWhatLeavesItSomethingToLeanFor() {
        WindModel calm = new WindModel(0, 0, 1);
        rise(calm);
        led(6, 0, 30, calm);
        assertThat(off()).isLessThan(0.5);
        assertThat(body.position().up()).isBetween(UP - 0.5, UP + 0.5);
        led(0, 6, 30, calm);
        assertThat(off()).isLessThan(0.5);
        led(0, 0, 30, calm);
        assertThat(off()).isLessThan(0.2);
        assertThat(body.groundSpeed()).isLessThan(0.1);
    }

    @Test
    void fliesNoFasterThanItMayLeanFor() {
        WindModel calm = new WindModel(0, 0, 1);
        rise(calm);
        led(15, 0, 40, calm);
        assertThat(body.groundSpeed()).isBetween(11.3, 11.7);
        assertThat(Math.toDegrees(-body.pitch())).isBetween(29.5, 30.1);
    }

    @Test
    void fliesStraightOnWhereItIsAskedForMoreThanItMayLeanFor() {
        WindModel calm = new WindModel(0, 0, 1);
        rise(calm);
        led(15, 0, 30, calm);
        north = body.position().north() + 8;
        led(10, 10, 3, calm);
        double course = Math.toDegrees(Math.atan2(body.velocityEast(), body.velocityNorth()));
        assertThat(course).as("it was to turn by 45 degrees").isLessThan(30);
    }
}
