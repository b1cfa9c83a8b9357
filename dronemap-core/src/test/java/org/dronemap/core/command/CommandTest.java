package org.dronemap.core.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.mission.RallyPoint;
import org.junit.jupiter.api.Test;

class CommandTest {
    private static final Geodetic HERE = new Geodetic(47, 8);

    @Test
    void saysHowManyOfWhatEvenWhenThereIsOneOnly() {
        FenceArea zone = new FenceArea.Circle(true, HERE, 100);
        RallyPoint point = new RallyPoint(HERE, 20);
        MissionItem climb = new MissionItem.TakeOff(20);

        assertThat(new Command.UploadMission(new Mission(List.of(climb))).summary())
                .isEqualTo("upload a mission of 1 item");
        assertThat(new Command.UploadMission(new Mission(List.of(climb, new MissionItem.Land()))).summary())
                .isEqualTo("upload a mission of 2 items");
        assertThat(new SetFence(List.of(zone)).summary()).isEqualTo("set a fence of 1 part");
        assertThat(new SetRallyPoints(List.of(point)).summary()).isEqualTo("set 1 rally point");
    }
}
