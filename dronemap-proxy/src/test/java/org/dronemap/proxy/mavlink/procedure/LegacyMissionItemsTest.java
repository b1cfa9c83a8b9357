package org.dronemap.proxy.mavlink.procedure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.dronemap.mavlink.message.MissionItem;
import org.dronemap.mavlink.message.MissionItemInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class LegacyMissionItemsTest {
    private static final int WAYPOINT = 16;
    private static final int GLOBAL_RELATIVE = 3;

    private static MissionItemInt exact(int frame, int command, int x, int y) {
        return new MissionItemInt(1, 2, 3, frame, command, 1, 1, 4f, 5f, 6f, 7f, x, y, 30f, 1);
    }

    @Test
    void turnsPlacesOfTheGlobeIntoDegreesAndBack() {
        MissionItem older = LegacyMissionItems.older(exact(GLOBAL_RELATIVE, WAYPOINT, 473_977_418, -85_455_938));

        assertThat(older.x()).isCloseTo(47.3977418f, within(1e-5f));
        assertThat(older.y()).isCloseTo(-8.5455938f, within(1e-6f));
        assertThat(LegacyMissionItems.exact(older).x()).isCloseTo(473_977_418, within(50));
        assertThat(LegacyMissionItems.exact(older).y()).isCloseTo(-85_455_938, within(10));
    }

    /** Local frame, no frame, and camera commands, whose fifth and sixth parameters stand where a place would. */
    @ParameterizedTest
    @CsvSource({"1, 16", "2, 183", "3, 203", "0, 203", "3, 202"})
    void leavesNumbersThatAreNoPlaceAsTheyAre(int frame, int command) {
        MissionItemInt number = exact(frame, command, 1, -20);

        MissionItem older = LegacyMissionItems.older(number);

        assertThat(older.x()).isEqualTo(1f);
        assertThat(older.y()).isEqualTo(-20f);
        assertThat(LegacyMissionItems.exact(older)).isEqualTo(number);
    }

    @Test
    void keepsAllElse() {
        MissionItemInt item = exact(GLOBAL_RELATIVE, WAYPOINT, 0, 0);

        assertThat(LegacyMissionItems.exact(LegacyMissionItems.older(item))).isEqualTo(item);
    }
}
