package org.dronemap.proxy.roslink;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.dronemap.core.drone.AreaMap;
import org.dronemap.core.drone.Picture;
import org.dronemap.core.drone.RangeScan;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.proxy.roslink.wire.Base64Text;
import org.dronemap.proxy.roslink.wire.RobotMessage;
import org.jspecify.annotations.Nullable;

/** Translates laser scans, images and maps of a ROSLink robot into drone events. Owned by the session's lane. */
final class RobotSensorTranslator {
    private static final double USUAL_MAP_METERS = 20;
    private static final double LEAST_RANGE_METERS = 1e-3;

    private final Consumer<DroneEvent> news;
    private final Runnable unreadable;

    /** {@code unreadable} is told of each picture that is none. */
    RobotSensorTranslator(Consumer<DroneEvent> news, Runnable unreadable) {
        this.news = news;
        this.unreadable = unreadable;
    }

    void scanned(RobotMessage.Scan scan) {
        Double first = scan.angleMin();
        Double step = scan.angleIncrement();
        if (first == null || step == null || scan.ranges().isEmpty()) {
            return;
        }
        List<@Nullable Double> ranges = scan.ranges().stream()
                .<@Nullable Double>map(range -> isMeasured(range, scan) ? range : null)
                .toList();
        news.accept(new DroneEvent.ScanReported(new RangeScan(first, step, ranges)));
    }

    /** Beyond its bounds a range finder says something, but measures nothing. */
    private static boolean isMeasured(@Nullable Double range, RobotMessage.Scan scan) {
        if (range == null || range < LEAST_RANGE_METERS) {
            return false;
        }
        Double least = scan.rangeMin();
        Double most = scan.rangeMax();
        return (least == null || range >= least) && (most == null || range < most);
    }

    void saw(RobotMessage.Image image) {
        picture(image.base64()).ifPresent(picture -> news.accept(new DroneEvent.PictureReported(picture)));
    }

    /** True when it is a map. Older bridges say its size in pixels of an unknown size, and not where it lies: it is taken for the usual one. */
    boolean mapped(RobotMessage.MapImage map) {
        Optional<Picture> picture = picture(map.base64());
        picture.ifPresent(drawn -> {
            boolean pixels = map.xOffset() == null && map.yOffset() == null && map.resolution() == null;
            double width = pixels ? USUAL_MAP_METERS : meters(map.width(), map.resolution());
            double height = pixels ? USUAL_MAP_METERS : meters(map.height(), map.resolution());
            news.accept(new DroneEvent.MapReported(
                    new AreaMap(drawn, edge(map.xOffset(), width), edge(map.yOffset(), height), width, height)));
        });
        return picture.isPresent();
    }

    /** With a resolution a size is one in pixels. */
    private static double meters(@Nullable Double size, @Nullable Double resolution) {
        double meters = size == null ? 0 : size * (resolution == null || resolution <= 0 ? 1 : resolution);
        return meters > 0 && meters <= 10_000 ? meters : USUAL_MAP_METERS;
    }

    private static double edge(@Nullable Double offset, double size) {
        return offset == null || Math.abs(offset) > 10_000 ? -size / 2 : offset;
    }

    private Optional<Picture> picture(String base64) {
        Optional<Picture> picture = Base64Text.decode(base64).flatMap(Picture::of);
        if (picture.isEmpty()) {
            unreadable.run();
        }
        return picture;
    }
}
