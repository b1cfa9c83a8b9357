package org.dronemap.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.mavlink.message.GpsRawInt;
import org.dronemap.sim.control.SimulatorControlCommands;
import org.dronemap.sim.physics.NeuPosition;
import org.junit.jupiter.api.Test;

/** What a vehicle believes, and where it is in truth, when its sensors are as they are. */
class NoiseTest {
    private static final int ON_GROUND = 1;

    private static double mistake(VehicleTestBench bench) {
        NeuPosition believed = bench.vehicle.craft().body().position();
        return believed.horizontalDistanceTo(bench.vehicle.craft().truePosition());
    }

    @Test
    void isMistakenAsFarAsItDeclares() {
        VehicleTestBench bench = VehicleTestBench.flying(20, "--noise", "7");
        int within = 0;
        for (int tens = 0; tens < 300; tens++) {
            bench.run(10);
            bench.vehicle.craft().battery().setRemainingPercent(100);
            within += mistake(bench) < 1.5 ? 1 : 0;
        }
        assertThat(within).as("of 300, two in three").isBetween(150, 270);
        bench.command(512, GpsRawInt.ID);
        assertThat(bench.last(GpsRawInt.ID, GpsRawInt::decode).hAcc()).isEqualTo(1_500);
    }

    @Test
    void driftsAMeterInTenMinutesAndStandsOnTheGroundWithIt() {
        VehicleTestBench bench = VehicleTestBench.flying(20, "--noise", "7");
        bench.run(600);
        double drift = bench.vehicle.craft().noise().height();
        assertThat(Math.abs(drift)).isBetween(0.95, 1.1);
        assertThat(bench.height()).as("as it believes").isBetween(19.0, 21.0);
        bench.vehicle.craft().battery().setRemainingPercent(100);
        bench.command(21);
        bench.run(60);
        assertThat(bench.vehicle.autopilot().landedState()).isEqualTo(ON_GROUND);
        assertThat(bench.armed()).isFalse();
        bench.command(512, GlobalPositionInt.ID);
        double told =
                bench.last(GlobalPositionInt.ID, GlobalPositionInt::decode).relativeAlt() / 1000.0;
        assertThat(Math.abs(told)).as("metres above home while it stands on it").isBetween(0.9, 1.4);
        String where = SimulatorControlCommands.run("where", List.of(bench.vehicle));
        assertThat(Double.parseDouble(where.split("\\s+")[3])).as("in truth").isBetween(-0.2, 0.2);
    }

    @Test
    void takesItsHomeForUpToFiveMetersHigherOrLower() {
        List<Double> homes = new ArrayList<>();
        for (int seed = 1; seed <= 20; seed++) {
            VehicleTestBench bench = VehicleTestBench.ready("--home", "47,8,500", "--noise", "" + seed);
            homes.add(bench.vehicle.craft().home().altitudeAmsl() - 500);
        }
        assertThat(homes).allMatch(offset -> Math.abs(offset) <= 5);
        assertThat(homes).anyMatch(offset -> offset > 1).anyMatch(offset -> offset < -1);
    }

    @Test
    void isTheSameWithTheSameSeedAndNoneWithoutOne() {
        double[] mistakes = new double[4];
        String[][] options = {{"--noise", "5"}, {"--noise", "5"}, {"--noise", "6"}, {}};
        for (int i = 0; i < mistakes.length; i++) {
            VehicleTestBench bench = VehicleTestBench.flying(20, options[i]);
            bench.run(30);
            mistakes[i] = mistake(bench);
        }
        assertThat(mistakes[0]).isEqualTo(mistakes[1]).isNotEqualTo(mistakes[2]);
        assertThat(mistakes[3]).isZero();
    }
}
