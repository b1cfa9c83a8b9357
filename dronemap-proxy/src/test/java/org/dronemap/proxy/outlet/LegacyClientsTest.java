package org.dronemap.proxy.outlet;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionClearAll;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItem;
import org.dronemap.mavlink.message.MissionRequest;
import org.dronemap.mavlink.message.MissionRequestInt;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Programs from before missions were asked for in whole numbers, DroneKit for one. */
class LegacyClientsTest {
    private static final int ITEMS = 6;
    private static final int WAYPOINT = 16;

    private final OutletTestBench house = new OutletTestBench();

    LegacyClientsTest() throws IOException {}

    @AfterEach
    void close() throws IOException {
        house.close();
    }

    @Test
    void whoAnswersTheOlderQuestionIsAskedThatWayFromThenOn() {
        OutletTestBench.Station ann = house.new Station("ann", 255, LegacyClientsTest::answer);
        ann.answer(MissionAck.ID, new MissionCount(1, 1, ITEMS, 0));
        assertThat(ann.of(MissionRequest.ID))
                .extracting(frame -> MissionRequest.decode(frame).seq())
                .startsWith(0, 1, 2, 3, 4, 5);
        // Only the first had to wait to be asked again.
        assertThat(ann.of(MissionRequestInt.ID))
                .extracting(frame -> MissionRequestInt.decode(frame).seq())
                .startsWith(0)
                .doesNotContain(1, 2, 3, 4);
    }

    @Test
    void aMissionThatIsAnnouncedWhileTheOneBeforeIsClearedIsTakenAfterwards() {
        OutletTestBench.Station ann = house.new Station("ann", 255, LegacyClientsTest::answer);
        ann.says(new MissionClearAll(1, 1, 0));
        ann.says(new MissionCount(1, 1, ITEMS, 0));
        house.await(() -> ann.of(MissionAck.ID).size() == 2, "only one of both is answered");
        assertThat(ann.of(MissionRequest.ID))
                .extracting(frame -> MissionRequest.decode(frame).seq())
                .contains(5);
    }

    private static void answer(OutletTestBench.Station station, Frame frame) {
        if (frame.messageId() == MissionRequest.ID) {
            int seq = MissionRequest.decode(frame).seq();
            int global = seq == 0 ? 0 : 3;
            station.says(new MissionItem(
                    1, 1, seq, global, WAYPOINT, 0, 1, 0, 0, 0, 0, 47.397F + seq / 1e3F, 8.545F, 20, 0));
        }
    }
}
