package org.dronemap.ws.drone;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Collections;
import java.util.List;
import org.dronemap.core.drone.AreaMap;
import org.dronemap.core.drone.Picture;
import org.dronemap.core.drone.RangeScan;
import org.dronemap.core.drone.SensorSnapshot;
import org.jspecify.annotations.Nullable;

/** The latest sensor readings of a drone as clients see them; null where there is none yet. */
@Schema(name = "SensedView")
record SensingView(
        @Nullable ScanView scan,
        @Nullable PictureView picture,
        @Nullable MapView map) {

    /** A sweep: metres along rays, counter-clockwise from the nose; angles in degrees. Null where nothing was met. */
    @Schema(name = "SensedScanView")
    public record ScanView(
            long number,
            Instant at,
            double firstAngle,
            double angleStep,

            @Schema(description = "Metres; null where nothing was met")
            List<@Nullable Double> ranges) {}

    /** The picture itself is at .../sensed/picture. */
    @Schema(name = "SensedPictureView")
    public record PictureView(long number, Instant at, String mediaType) {}

    /** Its edges in metres of the vehicle's own frame; the picture, drawn from above, is at .../sensed/map. */
    @Schema(name = "SensedMapView")
    public record MapView(
            long number, Instant at, String mediaType, double left, double bottom, double width, double height) {}

    static SensingView of(SensorSnapshot sensed) {
        return new SensingView(scan(sensed.scan()), picture(sensed.picture()), map(sensed.map()));
    }

    private static @Nullable ScanView scan(SensorSnapshot.@Nullable Sample<RangeScan> kept) {
        if (kept == null) {
            return null;
        }
        RangeScan scan = kept.value();
        return new ScanView(
                kept.number(),
                millis(kept.at()),
                Math.toDegrees(scan.firstAngleRadians()),
                Math.toDegrees(scan.stepRadians()),
                Collections.unmodifiableList(scan.rangesMeters()));
    }

    private static @Nullable PictureView picture(SensorSnapshot.@Nullable Sample<Picture> kept) {
        return kept == null
                ? null
                : new PictureView(kept.number(), millis(kept.at()), kept.value().mediaType());
    }

    private static @Nullable MapView map(SensorSnapshot.@Nullable Sample<AreaMap> kept) {
        if (kept == null) {
            return null;
        }
        AreaMap map = kept.value();
        return new MapView(
                kept.number(),
                millis(kept.at()),
                map.picture().mediaType(),
                map.leftMeters(),
                map.bottomMeters(),
                map.widthMeters(),
                map.heightMeters());
    }

    private static Instant millis(Instant instant) {
        return instant.truncatedTo(ChronoUnit.MILLIS);
    }
}
