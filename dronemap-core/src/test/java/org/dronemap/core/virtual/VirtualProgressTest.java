package org.dronemap.core.virtual;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.junit.jupiter.api.Test;

class VirtualProgressTest {
    private static final VirtualRun WAITS = VirtualFixtures.asked(4);

    private static VirtualRun flying(int flown) {
        return VirtualFixtures.bound(4, "d1")
                .to(VirtualRunStage.FLYING, "The drone flies the mission.", VirtualFixtures.NOW)
                .flown(flown);
    }

    private static VirtualRun over(VirtualRunStage stage, int flown) {
        return flying(flown).unbound(stage, "It is over.", null, VirtualFixtures.NOW.plusSeconds(9));
    }

    @Test
    void ofOneRunItIsWhatThatRunIs() {
        VirtualProgress progress = VirtualProgress.of(List.of(flying(1)));
        assertThat(progress)
                .isEqualTo(new VirtualProgress(
                        VirtualRunStage.FLYING, "The drone flies the mission.", 1, 4, 1, VirtualFixtures.NOW));
    }

    @Test
    void countsWaypointsAndDronesOfAllShares() {
        VirtualProgress progress =
                VirtualProgress.of(List.of(flying(3), WAITS, over(VirtualRunStage.DONE, 4), flying(0)));
        assertThat(progress.stage()).isEqualTo(VirtualRunStage.FLYING);
        assertThat(progress.flown()).isEqualTo(7);
        assertThat(progress.total()).isEqualTo(16);
        assertThat(progress.drones()).isEqualTo(2);
        assertThat(progress.sentence())
                .isEqualTo("4 shares: 2 under way, 1 waiting for a drone, 1 done; 7 of 16 waypoints are flown."
                        + " Share 2: It waits for a drone.");
        assertThat(progress.changedAt()).isEqualTo(VirtualFixtures.NOW.plusSeconds(9));
    }

    @Test
    void itIsDoneWhenAllSharesAre() {
        VirtualRun done = over(VirtualRunStage.DONE, 4);
        assertThat(VirtualProgress.of(List.of(done, done)).sentence())
                .isEqualTo("Done: all waypoints are flown, in 2 shares.");
        VirtualProgress failed = VirtualProgress.of(List.of(done, over(VirtualRunStage.FAILED, 1)));
        assertThat(failed.stage()).isEqualTo(VirtualRunStage.FAILED);
        assertThat(failed.sentence()).contains("1 failed, 1 done; 5 of 8 waypoints are flown.", "Share 2: It is over.");
        assertThat(VirtualProgress.of(List.of(done, over(VirtualRunStage.STOPPED, 1))))
                .extracting(VirtualProgress::stage, VirtualProgress::sentence)
                .containsExactly(VirtualRunStage.STOPPED, "It was stopped: 5 of 8 waypoints are flown.");
    }

    @Test
    void onlyAMissionOfWhichNothingIsFlownIsDividedAndOnlyOnce() {
        VirtualRunOrder order = new VirtualRunOrder(1, VirtualFixtures.mission(4), MissionCloudLossPolicy.CONTINUE, 3);
        VirtualRun asked = VirtualRun.asked(order, VirtualFixtures.NOW);
        assertThat(asked.isDivisible()).isTrue();
        assertThat(asked.flown(1).isDivisible()).isFalse();
        assertThat(WAITS.isDivisible()).isFalse();
        assertThat(asked.divided(List.of(VirtualFixtures.mission(2), VirtualFixtures.mission(2)), VirtualFixtures.NOW))
                .hasSize(2)
                .allMatch(share -> share.isWaiting() && !share.isDivisible() && share.ticket() == 1);
    }
}
