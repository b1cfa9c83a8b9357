package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.dronemap.core.command.SetFence;
import org.dronemap.core.drone.OnboardFence;
import org.dronemap.core.drone.OnboardRallyPoints;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.mission.FenceReturnPoint;
import org.dronemap.core.mission.HeightReference;
import org.dronemap.core.mission.RallyPoint;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.proxy.mavlink.procedure.MavlinkTarget;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class FenceCodecTest {
    private static final MavlinkTarget TARGET = new MavlinkTarget(1, 1, message -> {});
    private static final FenceArea CIRCLE = new FenceArea.Circle(false, point(4), 25.5);
    private static final List<FenceArea> ZONES = List.of(
            new FenceArea.Polygon(true, List.of(point(0), point(1), point(2), point(3))),
            CIRCLE,
            new FenceArea.Polygon(false, List.of(point(5), point(6), point(7))));

    private static Geodetic point(int number) {
        return new Geodetic(47 + number / 1000.0, 8 - number / 1000.0);
    }

    private static List<MissionItemInt> wire(List<FenceArea> zones) {
        return FenceCodec.fenceToWire(new SetFence(zones), TARGET);
    }

    private static MissionItemInt item(int command, int frame, double first, double z) {
        return new MissionItemInt(
                1, 1, 0, frame, command, 0, 1, (float) first, 0, 0, 0, 470_010_000, 80_010_000, (float) z, 1);
    }

    @Test
    void readsTheFenceThatItWrote() {
        List<MissionItemInt> wire = wire(ZONES);

        assertThat(wire).hasSize(8).allMatch(item -> item.missionType() == 1);
        assertThat(wire).extracting(MissionItemInt::seq).containsExactly(0, 1, 2, 3, 4, 5, 6, 7);
        assertThat(wire)
                .extracting(MissionItemInt::command)
                .containsExactly(5001, 5001, 5001, 5001, 5004, 5002, 5002, 5002);
        assertThat(wire).extracting(MissionItemInt::param1).startsWith(4f, 4f, 4f, 4f, 25.5f, 3f);
        assertThat(FenceCodec.fenceFromWire(wire)).isEqualTo(OnboardFence.of(ZONES));
    }

    @ParameterizedTest
    @ValueSource(ints = {3, 100, 101, 255, 1000})
    void readsAreasOfManyCornersWhole(int corners) {
        List<Geodetic> round = IntStream.range(0, corners)
                .mapToObj(i -> new Geodetic(
                        46 + Math.round(1e5 * Math.cos(2 * Math.PI * i / corners)) / 1e7,
                        9 + Math.round(1e5 * Math.sin(2 * Math.PI * i / corners)) / 1e7))
                .toList();
        SetFence fence = new SetFence(
                List.of(new FenceArea.Polygon(true, round), CIRCLE),
                new FenceReturnPoint(point(9), 40, HeightReference.HOME));

        OnboardFence read = FenceCodec.fenceFromWire(FenceCodec.fenceToWire(fence, TARGET));

        assertThat(read).isEqualTo(new OnboardFence(fence.zones(), fence.returnPoint(), List.of()));
    }

    @ParameterizedTest
    @ValueSource(floats = {0.01f, 0.5f, 0.1234567f, 20.1f, 99_999.99f})
    void readsRadiiAsTheyAre(float radius) {
        List<MissionItemInt> wire = List.of(item(5003, 0, radius, 0));

        OnboardFence read = FenceCodec.fenceFromWire(wire);

        assertThat(read.leftOut()).isEmpty();
        assertThat(wire(read.areas())).extracting(MissionItemInt::param1).containsExactly(radius);
    }

    @ParameterizedTest
    @CsvSource({"0, AMSL", "5, AMSL", "3, HOME", "6, HOME", "10, TERRAIN", "11, TERRAIN"})
    void heightsKeepWhatTheyAreMeasuredFrom(int frame, HeightReference reference) {
        MissionItemInt rally = item(5100, frame, 0, 60.1);
        MissionItemInt back = item(5000, frame, 0, 60.1);

        OnboardRallyPoints points = FenceCodec.rallyFromWire(List.of(rally));
        OnboardFence fence = FenceCodec.fenceFromWire(List.of(back));

        assertThat(points)
                .isEqualTo(
                        OnboardRallyPoints.of(List.of(new RallyPoint(new Geodetic(47.001, 8.001), 60.1, reference))));
        assertThat(fence.returnPoint()).isEqualTo(new FenceReturnPoint(new Geodetic(47.001, 8.001), 60.1, reference));
        int written = frame == 5 ? 0 : frame == 6 ? 3 : frame == 11 ? 10 : frame;
        assertThat(FenceCodec.rallyToWire(points.points(), TARGET))
                .extracting(MissionItemInt::frame)
                .containsExactly(written);
        assertThat(FenceCodec.fenceToWire(new SetFence(List.of(), fence.returnPoint()), TARGET))
                .extracting(MissionItemInt::frame)
                .containsExactly(written);
    }

    @Test
    void aReturnPointWithoutHeightHasNone() {
        OnboardFence fence = FenceCodec.fenceFromWire(List.of(item(5000, 0, 0, 0)));

        assertThat(fence.returnPoint()).isEqualTo(FenceReturnPoint.of(new Geodetic(47.001, 8.001)));
    }

    /** What stands among good items, and what is said of it. */
    static Stream<Arguments> oddPieces() {
        List<MissionItemInt> square = wire(ZONES.subList(0, 1));
        return Stream.of(
                Arguments.of(
                        square.subList(0, 3),
                        "Items 2 to 4 (an area to stay in) should have 4 corners, and there are 3 in a row."),
                Arguments.of(
                        List.of(item(5001, 0, 2, 0), item(5001, 0, 2, 0)),
                        "Items 2 to 3 (an area to stay in) should have 2 corners; an area has 3 to 1000."),
                Arguments.of(
                        List.of(item(5002, 0, 0, 0)),
                        "Item 2 (an area to stay out of) should have 0 corners; an area has 3 to 1000."),
                Arguments.of(
                        List.of(item(5003, 0, 0, 0)),
                        "Item 2 (a circle to stay in) has a radius of 0.0 m; a circle has 0.01 to 100000 m."),
                Arguments.of(
                        List.of(item(5004, 0, Float.NaN, 0)),
                        "Item 2 (a circle to stay out of) has a radius of NaN m; a circle has 0.01 to 100000 m."),
                Arguments.of(
                        List.of(item(5000, 2, 0, 30)),
                        "Item 2 (the return point) has a height of 30.0 m in frame 2, which cannot be told."),
                Arguments.of(List.of(item(5005, 0, 0, 0)), "Item 2 (command 5005) is no part of a fence."));
    }

    @ParameterizedTest
    @MethodSource("oddPieces")
    void anOddPieceIsNamedAndTheRestIsRead(List<MissionItemInt> odd, String words) {
        List<MissionItemInt> wire = new ArrayList<>(wire(List.of(CIRCLE)));
        wire.addAll(odd);
        wire.addAll(wire(List.of(CIRCLE)));

        OnboardFence read = FenceCodec.fenceFromWire(wire);

        assertThat(read.areas()).containsExactly(CIRCLE, CIRCLE);
        assertThat(read.leftOut()).containsExactly(words);
    }

    @Test
    void cornersOfTwoAreasAreNotMixed() {
        List<MissionItemInt> in = wire(ZONES.subList(0, 1));
        List<MissionItemInt> out =
                wire(List.of(new FenceArea.Polygon(false, List.of(point(5), point(6), point(7), point(8)))));
        List<MissionItemInt> wire = new ArrayList<>(in.subList(0, 2));
        wire.addAll(out);

        OnboardFence read = FenceCodec.fenceFromWire(wire);

        assertThat(read.areas()).hasSize(1).allMatch(area -> !area.inside());
        assertThat(read.leftOut()).hasSize(1);
    }

    @Test
    void aPlaceOffTheEarthIsNotMovedOntoIt() {
        MissionItemInt off = new MissionItemInt(1, 1, 0, 0, 5003, 0, 1, 20f, 0, 0, 0, 950_000_000, 80_000_000, 0f, 1);
        MissionItemInt rally = new MissionItemInt(1, 1, 0, 3, 5100, 0, 1, 0f, 0, 0, 0, 950_000_000, 80_000_000, 30f, 2);

        assertThat(FenceCodec.fenceFromWire(List.of(off)).leftOut())
                .containsExactly("Item 1 (a circle to stay in) is round no place, 95.0000000, 8.0000000.");
        assertThat(FenceCodec.rallyFromWire(List.of(rally)).leftOut())
                .containsExactly("Item 1 is no place, 95.0, 8.0.");
    }

    @ParameterizedTest
    @CsvSource({"5100, 2, 30", "5100, 3, 10001", "5100, 3, NaN", "16, 3, 30"})
    void anOddRallyPointIsNamedAndTheRestIsRead(int command, int frame, float meters) {
        MissionItemInt good = item(5100, 3, 0, 20);

        OnboardRallyPoints read = FenceCodec.rallyFromWire(Arrays.asList(good, item(command, frame, 0, meters), good));

        assertThat(read.points()).hasSize(2);
        assertThat(read.leftOut()).hasSize(1).allMatch(words -> words.startsWith("Item 2 "));
    }
}
