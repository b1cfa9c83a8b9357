package org.dronemap.ws.service;

import java.time.DateTimeException;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceZone;
import org.dronemap.core.zone.AltitudeBand;
import org.dronemap.core.zone.Binding;
import org.dronemap.core.zone.BreachAction;
import org.dronemap.core.zone.ShapeFaults;
import org.dronemap.core.zone.Validity;
import org.jspecify.annotations.Nullable;

/** Turns a feature that a client wrote into the parts of a zone, or says which member is wrong. */
final class ZoneReader {
    private static final int LONGEST_NAME = 80;
    private static final String NOTHING = "nothing";
    private static final String SHAPES = "Polygon or Point";
    private static final String CORNERS = "3 to 100 corners";
    private static final String MOMENT = "a time such as 2026-05-04T10:00:00Z";

    private final String at;
    private final ZoneFeature.ZoneGeometry geometry;
    private final ZoneFeature.ZoneProperties properties;

    /** {@code at} is what stands before the names of fields, such as {@code features[2].}. */
    ZoneReader(String at, ZoneFeature feature) {
        this.at = at;
        if (!"Feature".equals(feature.type())) {
            throw InvalidInput.outside(at + "type", "Feature", quoted(feature.type()));
        }
        if (feature.geometry() == null) {
            throw InvalidInput.missing(at + "geometry", "a " + SHAPES);
        }
        if (feature.properties() == null) {
            throw InvalidInput.missing(at + "properties", "an object with at least a name");
        }
        geometry = feature.geometry();
        properties = feature.properties();
    }

    String name() {
        return Names.checked(at + "properties.name", properties.name(), LONGEST_NAME);
    }

    FenceZone shape() {
        boolean inside = switch (properties.kind() == null ? "exclusion" : properties.kind()) {
            case "exclusion" -> false;
            case "inclusion" -> true;
            default ->
                throw InvalidInput.outside(at + "properties.kind", "exclusion or inclusion", quoted(properties.kind()));
        };
        FenceZone shape = switch (geometry.type() == null ? "" : geometry.type()) {
            case "Polygon" -> new FenceZone.Polygon(inside, corners());
            case "Point" ->
                new FenceZone.Circle(
                        inside,
                        position(at + "geometry.coordinates", geometry.coordinates()),
                        Ranges.checked(at + "properties.radius", properties.radius(), 1, 100_000, "m"));
            default -> throw InvalidInput.outside(at + "geometry.type", SHAPES, quoted(geometry.type()));
        };
        Optional<String> fault = ShapeFaults.of(shape);
        if (fault.isPresent()) {
            throw new InvalidInput(at + "geometry", "a simple area", fault.get());
        }
        return shape;
    }

    private List<Geodetic> corners() {
        String field = at + "geometry.coordinates";
        List<?> rings = list(field, "one ring of positions", geometry.coordinates());
        if (rings.size() != 1) {
            throw new InvalidInput(
                    field, "one ring", "An area with holes cannot be guarded as one; draw it in parts without holes.");
        }
        List<?> ring = list(field + "[0]", CORNERS, rings.get(0));
        List<Geodetic> corners = new ArrayList<>();
        for (int i = 0; i < ring.size(); i++) {
            corners.add(position(field + "[0][" + i + "]", ring.get(i)));
        }
        // A ring of GeoJSON ends where it began.
        if (corners.size() > 1 && corners.get(0).equals(corners.get(corners.size() - 1))) {
            corners.remove(corners.size() - 1);
        }
        if (corners.size() < 3 || corners.size() > 100) {
            throw InvalidInput.outside(field + "[0]", CORNERS, corners.size());
        }
        return corners;
    }

    private static List<?> list(String field, String allowed, @Nullable Object value) {
        if (value instanceof List<?> list) {
            return list;
        }
        throw InvalidInput.outside(field, allowed, value == null ? NOTHING : value);
    }

    private static Geodetic position(String field, @Nullable Object value) {
        List<?> numbers = list(field, "longitude and latitude", value);
        if (numbers.size() < 2) {
            throw InvalidInput.outside(field, "longitude and latitude", numbers);
        }
        return new Geodetic(
                Ranges.latitude(field + "[1]", number(field + "[1]", numbers.get(1))),
                Ranges.longitude(field + "[0]", number(field + "[0]", numbers.get(0))));
    }

    private static double number(String field, @Nullable Object value) {
        if (value instanceof Number number) {
            return number.doubleValue();
        }
        throw InvalidInput.outside(field, "a number", value == null ? NOTHING : value);
    }

    AltitudeBand band() {
        Altitude.Reference reference = switch (properties.altitudeReference() == null
                ? "home"
                : properties.altitudeReference()) {
            case "home" -> Altitude.Reference.HOME;
            case "amsl" -> Altitude.Reference.AMSL;
            default ->
                throw InvalidInput.outside(
                        at + "properties.altitudeReference", "home or amsl", quoted(properties.altitudeReference()));
        };
        Double floor = height("floor", properties.floor());
        Double ceiling = height("ceiling", properties.ceiling());
        if (floor != null && ceiling != null && floor >= ceiling) {
            throw InvalidInput.outside(at + "properties.ceiling", "above the floor of " + floor + " m", ceiling);
        }
        return new AltitudeBand(floor, ceiling, reference);
    }

    private @Nullable Double height(String field, @Nullable Double meters) {
        return meters == null ? null : Double.valueOf(Ranges.altitude(at + "properties." + field, meters));
    }

    Binding binding() {
        if (properties.user() != null && properties.drone() != null) {
            throw new InvalidInput(
                    at + "properties.user", "a user or a drone", "A zone binds a user or a drone, not both.");
        }
        if (properties.user() != null) {
            return new Binding.OfUser(properties.user());
        }
        return properties.drone() == null ? Binding.EVERYBODY : ofDrone(properties.drone());
    }

    private Binding ofDrone(String id) {
        try {
            return new Binding.OfDrone(new DroneId(id));
        } catch (IllegalArgumentException e) {
            throw InvalidInput.outside(at + "properties.drone", "the id of a drone", quoted(id));
        }
    }

    Validity validity() {
        Instant from = moment("from", properties.from());
        Instant until = moment("until", properties.until());
        if (from != null && until != null && !from.isBefore(until)) {
            throw InvalidInput.outside(at + "properties.until", "after " + from, until);
        }
        return new Validity(from, until);
    }

    private @Nullable Instant moment(String field, @Nullable String text) {
        if (text == null) {
            return null;
        }
        try {
            return OffsetDateTime.parse(text).toInstant();
        } catch (DateTimeException e) {
            throw InvalidInput.outside(at + "properties." + field, MOMENT, quoted(text));
        }
    }

    BreachAction onBreach() {
        return switch (properties.onBreach() == null ? "hold" : properties.onBreach()) {
            case "hold" -> BreachAction.HOLD;
            case "returnToLaunch" -> BreachAction.RETURN_TO_LAUNCH;
            case "land" -> BreachAction.LAND;
            default ->
                throw InvalidInput.outside(
                        at + "properties.onBreach", "hold, returnToLaunch or land", quoted(properties.onBreach()));
        };
    }

    private static String quoted(@Nullable String text) {
        return text == null ? NOTHING : "\"" + text + "\"";
    }
}
