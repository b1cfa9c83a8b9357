package org.dronemap.core.drone;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronemap.core.mission.MissionItem;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

class MissionProgressTest {
    private static final List<MissionItem> TWO = List.of(new MissionItem.TakeOff(10), new MissionItem.Land());

    @Test
    void isCompleteWhenTheVehicleSaysSo() {
        assertThat(progress(MissionPhase.COMPLETE, List.of()).complete()).isTrue();
        assertThat(progress(MissionPhase.RUNNING, List.of(0, 1)).complete())
                .as("its own word counts more than what was reached on an earlier flight")
                .isFalse();
    }

    @Test
    void isCompleteWithItsLastItemWhenTheVehicleSaysNothing() {
        assertThat(progress(null, List.of(0)).complete()).isFalse();
        assertThat(progress(null, List.of(0, 1)).complete()).isTrue();
        assertThat(MissionProgress.UNKNOWN.complete()).isFalse();
    }

    private static MissionProgress progress(@Nullable MissionPhase phase, List<Integer> reached) {
        return new MissionProgress(TWO, null, 1, phase, reached, null);
    }
}
