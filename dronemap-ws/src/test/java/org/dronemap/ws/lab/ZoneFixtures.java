package org.dronemap.ws.lab;

import java.util.List;
import java.util.stream.Stream;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.ws.zone.ZoneFeature;
import org.dronemap.ws.zone.ZoneGeometry;
import org.jspecify.annotations.Nullable;

/** No-fly zones as a person draws them. */
public final class ZoneFixtures {
    private ZoneFixtures() {}

    /** For one drone: a rectangle in metres from where that was put down. */
    public static ZoneFeature box(
            LabDrone drone,
            double south,
            double north,
            double half,
            @Nullable String onBreach,
            @Nullable Double floor) {
        List<List<Double>> ring = Stream.of(
                        drone.place(south, -half),
                        drone.place(south, half),
                        drone.place(north, half),
                        drone.place(north, -half),
                        drone.place(south, -half))
                .map(ZoneFixtures::position)
                .toList();
        return new ZoneFeature(
                "Feature",
                null,
                new ZoneGeometry.Polygon(List.of(ring)),
                properties("School", null, floor, drone, onBreach));
    }

    /** For one drone, or for all. */
    public static ZoneFeature circle(
            String name, Geodetic middle, double radius, @Nullable LabDrone drone, @Nullable String onBreach) {
        return new ZoneFeature(
                "Feature",
                null,
                new ZoneGeometry.Point(position(middle)),
                properties(name, radius, null, drone, onBreach));
    }

    private static List<Double> position(Geodetic place) {
        return List.of(place.longitudeDegrees(), place.latitudeDegrees());
    }

    private static ZoneFeature.ZoneProperties properties(
            String name,
            @Nullable Double radius,
            @Nullable Double floor,
            @Nullable LabDrone drone,
            @Nullable String onBreach) {
        return new ZoneFeature.ZoneProperties(
                name,
                "exclusion",
                radius,
                floor,
                null,
                null,
                null,
                drone == null ? null : drone.id().value(),
                null,
                null,
                onBreach,
                null,
                null);
    }
}
