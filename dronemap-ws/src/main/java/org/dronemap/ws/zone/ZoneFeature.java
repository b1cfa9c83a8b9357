package org.dronemap.ws.zone;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
import jakarta.validation.constraints.Size;
import java.time.Instant;
import java.util.List;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.core.zone.BreachAction;
import org.dronemap.core.zone.Zone;
import org.dronemap.core.zone.ZoneBinding;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.FieldRanges;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/** A zone of the cloud as a GeoJSON feature (RFC 7946), which clients read and write in the same form. */
@Schema(name = "ZoneFeature", description = "A zone as a GeoJSON feature: a Polygon, or a Point with a radius.")
public record ZoneFeature(
        @Schema(allowableValues = {"Feature"}) @Nullable String type,

        @Schema(description = "Given by the server") @Nullable
        String id,

        @Nullable ZoneGeometry geometry,
        @Nullable ZoneProperties properties) {

    /** Properties of a zone's GeoJSON feature that GeoJSON itself does not define. */
    @Schema(name = "ZoneProperties")
    public record ZoneProperties(
            @Size(min = 1, max = ZoneReader.LONGEST_NAME) @Nullable
            String name,

            @Schema(
                    description = "exclusion: keep out, the default; inclusion: stay in",
                    allowableValues = {"exclusion", "inclusion"})
            @Nullable
            String kind,

            @Schema(description = "Point: metres, 1 to 100000")
            @Min(FieldRanges.LEAST_RADIUS)
            @Max(FieldRanges.MOST_RADIUS)
            @Nullable
            Double radius,

            @Schema(description = "metres; null: down to the ground")
            @Min(Altitude.LOWEST_PLANNED_METERS)
            @Max(Altitude.HIGHEST_PLANNED_METERS)
            @Nullable
            Double floor,

            @Schema(description = "metres; null: without end")
            @Min(Altitude.LOWEST_PLANNED_METERS)
            @Max(Altitude.HIGHEST_PLANNED_METERS)
            @Nullable
            Double ceiling,

            @Schema(description = "what floor and ceiling are measured from: home (the default) or amsl")
            @EnumValues(Altitude.Reference.class)
            @Nullable
            String altitudeReference,

            @Schema(description = "binds what this user flies; null: whoever flies") @Nullable
            String user,

            @Schema(description = "binds this drone; null: every drone") @Nullable
            String drone,

            @Schema(description = "ISO 8601; null: already") @Nullable
            String from,

            @Schema(description = "ISO 8601; null: for ever") @Nullable
            String until,

            @Schema(description = "left out: hold") @EnumValues(BreachAction.class) @Nullable
            String onBreach,

            @Schema(description = "Who changed it last; given by the server") @Nullable
            String by,

            @Schema(description = "Given by the server") @Nullable
            String changedAt) {
        /** Nothing but a name to come. */
        static final ZoneProperties NONE =
                new ZoneProperties(null, null, null, null, null, null, null, null, null, null, null, null, null);
    }

    /** All zones. */
    @Schema(name = "ZoneCollection")
    public record ZoneCollection(
            @Schema(allowableValues = {"FeatureCollection"}) @Nullable
            String type,

            @Nullable List<ZoneFeature> features) {
        static ZoneCollection of(List<Zone> zones, OrganisationId to) {
            return new ZoneCollection(
                    "FeatureCollection",
                    zones.stream().map(zone -> ZoneFeature.of(zone, to)).toList());
        }
    }

    /** As people of that organisation see it; who made it is known to its own alone. */
    public static ZoneFeature of(Zone zone, OrganisationId to) {
        return new ZoneFeature(
                "Feature",
                zone.id(),
                ZoneGeometry.of(zone.shape()),
                properties(zone, zone.organisation().equals(to)));
    }

    /** What drones of a run keep to, once for each that it binds: by name, place and heights, without an id or a maker. */
    public static List<ZoneFeature> of(Barrier barrier) {
        return barrier.drones().isEmpty()
                ? List.of(of(barrier, null))
                : barrier.drones().stream()
                        .map(DroneId::value)
                        .sorted()
                        .map(drone -> of(barrier, drone))
                        .toList();
    }

    private static ZoneFeature of(Barrier barrier, @Nullable String drone) {
        return new ZoneFeature(
                "Feature",
                null,
                ZoneGeometry.of(barrier.shape()),
                new ZoneProperties(
                        barrier.name(),
                        kind(barrier.shape()),
                        radius(barrier.shape()),
                        barrier.band().floorMeters(),
                        barrier.band().ceilingMeters(),
                        WireNames.camel(barrier.band().reference()),
                        null,
                        drone,
                        null,
                        null,
                        null,
                        null,
                        null));
    }

    private static String kind(FenceArea shape) {
        return shape.inside() ? "inclusion" : "exclusion";
    }

    private static @Nullable Double radius(FenceArea shape) {
        return shape instanceof FenceArea.Circle circle ? Double.valueOf(circle.radiusMeters()) : null;
    }

    private static ZoneProperties properties(Zone zone, boolean namesMaker) {
        ZoneBinding binding = zone.binding();
        return new ZoneProperties(
                zone.name(),
                kind(zone.shape()),
                radius(zone.shape()),
                zone.band().floorMeters(),
                zone.band().ceilingMeters(),
                WireNames.camel(zone.band().reference()),
                binding instanceof ZoneBinding.OfUser user ? user.name() : null,
                binding instanceof ZoneBinding.OfDrone drone ? drone.id().value() : null,
                text(zone.validity().from()),
                text(zone.validity().until()),
                WireNames.camel(zone.onBreach()),
                namesMaker ? zone.changedBy() : null,
                text(zone.changedAt()));
    }

    private static @Nullable String text(@Nullable Instant moment) {
        return moment == null ? null : moment.toString();
    }
}
