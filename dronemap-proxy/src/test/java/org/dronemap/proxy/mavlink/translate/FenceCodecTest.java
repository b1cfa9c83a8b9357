package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.mission.RallyPoint;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.proxy.mavlink.procedure.MavlinkTarget;
import org.junit.jupiter.api.Test;

class FenceCodecTest {
    private static final MavlinkTarget TARGET = new MavlinkTarget(1, 1, message -> {});
    private static final List<FenceArea> ZONES = List.of(
            new FenceArea.Polygon(true, List.of(point(0), point(1), point(2), point(3))),
            new FenceArea.Circle(false, point(4), 25.5),
            new FenceArea.Polygon(false, List.of(point(5), point(6), point(7))));

    private static Geodetic point(int number) {
        return new Geodetic(47 + number / 1000.0, 8 - number / 1000.0);
    }

    @Test
    void readsTheFenceThatItWrote() {
        List<MissionItemInt> wire = FenceCodec.fenceToWire(ZONES, TARGET);

        assertThat(wire).hasSize(8).allMatch(item -> item.missionType() == 1);
        assertThat(wire).extracting(MissionItemInt::seq).containsExactly(0, 1, 2, 3, 4, 5, 6, 7);
        assertThat(wire)
                .extracting(MissionItemInt::command)
                .containsExactly(5001, 5001, 5001, 5001, 5004, 5002, 5002, 5002);
        assertThat(wire).extracting(MissionItemInt::param1).startsWith(4f, 4f, 4f, 4f, 25.5f, 3f);
        assertThat(FenceCodec.fenceFromWire(wire)).isEqualTo(ZONES);
    }

    @Test
    void readsTheRallyPointsThatItWrote() {
        List<RallyPoint> points = List.of(new RallyPoint(point(1), 20.1), new RallyPoint(point(2), 35));

        List<MissionItemInt> wire = FenceCodec.rallyToWire(points, TARGET);

        assertThat(wire).allMatch(item -> item.missionType() == 2 && item.command() == 5100 && item.frame() == 3);
        assertThat(FenceCodec.rallyFromWire(wire)).isEqualTo(points);
    }

    @Test
    void leavesOutAnAreaWhoseCornersAreNotAllThere() {
        List<MissionItemInt> wire = FenceCodec.fenceToWire(ZONES, TARGET).subList(0, 3);

        assertThat(FenceCodec.fenceFromWire(wire)).isEmpty();
    }
}
