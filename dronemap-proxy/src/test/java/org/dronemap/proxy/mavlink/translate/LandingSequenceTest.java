package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.mavlink.message.MissionItemInt;
import org.junit.jupiter.api.Test;

/** What a mission looks like by which a plane lands when it is sent home. */
class LandingSequenceTest {
    private static final int HOME = 16;
    private static final int TAKE_OFF = 22;
    private static final int WAYPOINT = 16;
    private static final int LAND_START = 189;
    private static final int LAND = 21;

    /** Some of them with a place, as Mission Planner writes them. */
    private static List<MissionItemInt> mission(int... commands) {
        List<MissionItemInt> items = new ArrayList<>();
        for (int command : commands) {
            items.add(new MissionItemInt(
                    255,
                    190,
                    items.size(),
                    3,
                    command,
                    0,
                    1,
                    0,
                    0,
                    0,
                    0,
                    473_977_000,
                    85_456_000 + items.size() * 10_000,
                    40,
                    0));
        }
        return items;
    }

    @Test
    void isAMarkAndALandingAfterIt() {
        assertThat(MissionCodec.hasLandingSequence(mission(HOME, TAKE_OFF, WAYPOINT, LAND_START, WAYPOINT, LAND)))
                .isTrue();
        assertThat(MissionCodec.hasLandingSequence(mission(HOME, TAKE_OFF, WAYPOINT, LAND)))
                .as("nothing leads to that landing but the whole mission")
                .isFalse();
        assertThat(MissionCodec.hasLandingSequence(mission(HOME, LAND, LAND_START, WAYPOINT)))
                .as("it ends in the air")
                .isFalse();
        assertThat(MissionCodec.hasLandingSequence(List.of())).isFalse();
    }

    @Test
    void isCalledByItsNameAmongTheItems() {
        assertThat(MissionCodec.fromWire(mission(HOME, LAND_START), 1))
                .containsExactly(new MissionItem.Other(
                        "begin of the landing sequence at 47.397700, 8.546600, 40.0 m above home"));
    }
}
