package org.dronemap.cognitive.follow;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.core.separation.Separation;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Simulated copters that follow at the same height come no closer to each other than they may. */
class FollowingDronesSeparationTest {
    private static final Separation USUAL = Separation.USUAL;

    @Test
    void keepsThreeRoundOneTargetApart() {
        MultiFollowTrial swarm = MultiFollowTrial.three(USUAL, 1, false);
        assertThat(swarm.fly(60)).isGreaterThan(USUAL.horizontalMeters());
        assertThat(swarm.fromTargets(60)).isLessThan(20);
    }

    @Test
    void keepsThreeApartThatWantToBeAtOnePlace() {
        assertThat(MultiFollowTrial.three(USUAL, 2, true).fly(45)).isGreaterThan(USUAL.horizontalMeters());
        assertThat(MultiFollowTrial.three(null, 2, true).fly(45))
                .as("nobody looking out")
                .isLessThan(5);
    }

    @Test
    void keepsTenFollowsApart() {
        assertThat(MultiFollowTrial.ten(USUAL, 1).fly(60)).isGreaterThan(USUAL.horizontalMeters());
    }

    @Test
    void keepsThemAsFarApartAsIsSet() {
        Separation wide = new Separation(20, 8);
        assertThat(MultiFollowTrial.ten(wide, 1).fly(40)).isGreaterThan(wide.horizontalMeters());
    }

    @Test
    void stepsAsideForWhoFliesPastInsteadOfBeingDrivenAlong() {
        for (double aside : new double[] {-20, -3, 0, 10}) {
            for (double speed : new double[] {10, 15}) {
                MultiFollowTrial swarm = MultiFollowTrial.passed(aside, 190, speed, 1);
                assertThat(swarm.fly(25 + 400 / speed))
                        .as("at %.0f m/s, %.0f m to its right", speed, -aside)
                        .isGreaterThan(USUAL.horizontalMeters());
                assertThat(swarm.farthest())
                        .as("from its target, %.0f m/s, %.0f m", speed, -aside)
                        .isLessThan(30);
            }
        }
    }

    @Test
    @Tag("soak")
    void keepsManyFollowsApart() {
        for (double meters : new double[] {Separation.LEAST_HORIZONTAL_METERS, 10, 20}) {
            RandomFollowStudy.Summary tally = RandomFollowStudy.swarms(0, 60, new Separation(meters, 5));
            assertThat(tally.failed()).as("closer than %.0f m", meters).isEmpty();
        }
    }

    @Test
    @Tag("soak")
    void noneOfTenThousandPassesAFenceOrFliesTooLow() {
        assertThat(RandomFollowStudy.fenced(0, 10_000).failed()).isEmpty();
    }
}
