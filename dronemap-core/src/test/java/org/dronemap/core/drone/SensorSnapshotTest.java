package org.dronemap.core.drone;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;

/** What sensors bring is bounded, counted, and never changes once it is there. */
class SensorSnapshotTest {
    private static final Instant THEN = Instant.parse("2026-03-04T05:06:07Z");
    private static final byte[] PNG = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', 7};

    @Test
    void countsEachKindByItself() {
        RangeScan scan = new RangeScan(0, 1, List.of(1.0));
        Picture picture = Picture.of(PNG).orElseThrow();
        SensorSnapshot sensed =
                SensorSnapshot.NOTHING.with(scan, THEN).with(scan, THEN).with(picture, THEN);

        assertThat(sensed.scan()).isEqualTo(new SensorSnapshot.Sample<>(scan, 2, THEN));
        assertThat(sensed.picture()).isEqualTo(new SensorSnapshot.Sample<>(picture, 1, THEN));
        assertThat(sensed.map()).isNull();
    }

    @Test
    void aPictureIsWhatItsFirstBytesSayAndNothingElse() {
        Picture picture = Picture.of(PNG).orElseThrow();
        assertThat(picture.mediaType()).isEqualTo("image/png");
        picture.bytes()[8] = 9;
        assertThat(picture.bytes()).isEqualTo(PNG);

        assertThat(Picture.of(new byte[0])).isEmpty();
        assertThat(Picture.of(Arrays.copyOf(PNG, 8))).isEmpty();
        assertThat(Picture.of("<html>0123456789".getBytes(StandardCharsets.US_ASCII)))
                .isEmpty();
        assertThat(Picture.of(Arrays.copyOf(PNG, Picture.MOST_BYTES))).isPresent();
        assertThat(Picture.of(Arrays.copyOf(PNG, Picture.MOST_BYTES + 1))).isEmpty();
    }

    @Test
    void refusesSweepsAndMapsWithoutASize() {
        assertThatThrownBy(() -> new RangeScan(0, 1, List.of())).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new RangeScan(0, 1, Collections.nCopies(RangeScan.MOST_RAYS + 1, 1.0)))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new RangeScan(Double.NaN, 1, List.of(1.0)))
                .isInstanceOf(IllegalArgumentException.class);
        Picture picture = Picture.of(PNG).orElseThrow();
        for (double size : new double[] {0, -1, Double.NaN, 1e9}) {
            assertThatThrownBy(() -> new AreaMap(picture, 0, 0, size, 1)).isInstanceOf(IllegalArgumentException.class);
        }
    }
}
