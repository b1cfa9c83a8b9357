package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.mavlink.message.MissionItemInt;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Heights of mission items that are shown by words alone: never without what they are measured from. */
class MissionHeightTextsTest {
    private static final int SPLINE = 82;

    @ParameterizedTest
    @CsvSource({
        "3, above home",
        "6, above home",
        "0, above sea level",
        "5, above sea level",
        "10, above the ground",
        "11, above the ground",
        "99, in frame 99"
    })
    void aHeightKeepsItsReference(int frame, String words) {
        MissionItemInt item =
                new MissionItemInt(255, 190, 0, frame, SPLINE, 0, 1, 0, 0, 0, 0, 473_977_000, 85_456_000, 60, 0);

        assertThat(MissionCodec.fromWire(List.of(item), 0))
                .containsExactly(new MissionItem.Other("spline waypoint at 47.397700, 8.545600, 60.0 m " + words));
    }
}
