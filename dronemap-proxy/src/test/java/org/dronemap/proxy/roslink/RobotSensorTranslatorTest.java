package org.dronemap.proxy.roslink;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import org.dronemap.core.drone.AreaMap;
import org.dronemap.core.drone.Picture;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.proxy.roslink.wire.RobotMessage;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** Sweeps, pictures and maps as bridges send them, whole and broken. */
class RobotSensorTranslatorTest {
    private static final byte[] JPEG = {(byte) 0xff, (byte) 0xd8, (byte) 0xff, (byte) 0xe0, 1, 2, 3};

    private final List<DroneEvent> news = new ArrayList<>();
    private int unreadable;
    private final RobotSensorTranslator senses = new RobotSensorTranslator(news::add, () -> unreadable++);

    @Test
    void whatIsBeyondTheBoundsOfARangeFinderWasNotMeasured() {
        senses.scanned(scan(-1.0, 0.5, Arrays.asList(0.05, 1.0, null, 3.5, 2.0, 0.0)));

        assertThat(news).singleElement().isInstanceOfSatisfying(DroneEvent.ScanReported.class, heard -> {
            assertThat(heard.scan().firstAngleRadians()).isEqualTo(-1.0);
            assertThat(heard.scan().rangesMeters()).containsExactly(null, 1.0, null, null, 2.0, null);
        });
    }

    @Test
    void aSweepWithoutAnglesOrRaysIsNone() {
        senses.scanned(scan(null, 0.5, List.of(1.0)));
        senses.scanned(scan(0.0, null, List.of(1.0)));
        senses.scanned(scan(0.0, 0.5, List.of()));
        assertThat(news).isEmpty();
    }

    private static RobotMessage.Scan scan(
            @Nullable Double first, @Nullable Double step, List<@Nullable Double> ranges) {
        return new RobotMessage.Scan(first, step, 0.1, 3.5, ranges);
    }

    @Test
    void aPictureMayBeBrokenIntoLines() {
        senses.saw(new RobotMessage.Image(
                Base64.getMimeEncoder(4, new byte[] {'\n'}).encodeToString(JPEG), null));

        assertThat(news).singleElement().isInstanceOfSatisfying(DroneEvent.PictureReported.class, heard -> {
            assertThat(heard.picture().bytes()).isEqualTo(JPEG);
            assertThat(heard.picture().mediaType()).isEqualTo("image/jpeg");
        });
    }

    @Test
    void whatIsNoPictureOrTooLargeIsCountedAndNotKept() {
        byte[] large = Arrays.copyOf(JPEG, Picture.MOST_BYTES + 1);
        senses.saw(new RobotMessage.Image("no base 64!", null));
        senses.saw(new RobotMessage.Image(Base64.getEncoder().encodeToString(new byte[] {1, 2, 3}), null));
        senses.saw(new RobotMessage.Image(Base64.getEncoder().encodeToString(large), null));

        assertThat(news).isEmpty();
        assertThat(unreadable).isEqualTo(3);
    }

    @Test
    void mapsAreInMetresInPixelsOrOfTheUsualSize() {
        assertThat(map(20.0, 10.0, -10.0, -5.0, null)).isEqualTo(List.of(-10.0, -5.0, 20.0, 10.0));
        assertThat(map(200.0, 100.0, -1.0, -2.0, 0.05)).isEqualTo(List.of(-1.0, -2.0, 10.0, 5.0));
        assertThat(map(200.0, 200.0, null, null, null)).isEqualTo(List.of(-10.0, -10.0, 20.0, 20.0));
        assertThat(map(null, -3.0, null, 1e9, -1.0)).isEqualTo(List.of(-10.0, -10.0, 20.0, 20.0));
    }

    private List<Double> map(
            @Nullable Double width,
            @Nullable Double height,
            @Nullable Double x,
            @Nullable Double y,
            @Nullable Double resolution) {
        news.clear();
        String data = Base64.getEncoder().encodeToString(JPEG);
        assertThat(senses.mapped(new RobotMessage.MapImage(data, width, height, x, y, resolution)))
                .isTrue();
        AreaMap map = ((DroneEvent.MapReported) news.get(0)).map();
        return List.of(map.leftMeters(), map.bottomMeters(), map.widthMeters(), map.heightMeters());
    }
}
