package org.dronemap.ws.zone;

import java.time.DateTimeException;
import java.time.Instant;
import java.time.OffsetDateTime;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.zone.AltitudeBand;
import org.dronemap.core.zone.BreachAction;
import org.dronemap.core.zone.ZoneBinding;
import org.dronemap.core.zone.ZoneValidity;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.AltitudeBandReader;
import org.dronemap.ws.reading.AreaReader;
import org.dronemap.ws.reading.NameRules;
import org.jspecify.annotations.Nullable;

/** Turns a GeoJSON feature that a client wrote into the parts of a zone, or rejects the faulty field. */
public final class ZoneReader {
    static final int LONGEST_NAME = 80;
    private static final String NOTHING = "nothing";
    private static final String MOMENT = "a time such as 2026-05-04T10:00:00Z";

    private final String at;
    private final ZoneGeometry geometry;
    private final ZoneFeature.ZoneProperties properties;

    /** {@code at} is what stands before the names of fields, such as {@code features[2].}. */
    public ZoneReader(String at, ZoneFeature feature) {
        this.at = at;
        if (!"Feature".equals(feature.type())) {
            throw InvalidInput.outside(ValueProblem.VALUE_NOT_ALLOWED, at + "type", "Feature", quoted(feature.type()));
        }
        if (feature.geometry() == null) {
            throw InvalidInput.missing(at + "geometry", "a " + AreaReader.SHAPES);
        }
        if (feature.properties() == null) {
            throw InvalidInput.missing(at + "properties", "an object with at least a name");
        }
        geometry = feature.geometry();
        properties = feature.properties();
    }

    public String name() {
        return NameRules.checked(at + "properties.name", properties.name(), LONGEST_NAME);
    }

    public FenceArea shape() {
        boolean inside = switch (properties.kind() == null ? "exclusion" : properties.kind()) {
            case "exclusion" -> false;
            case "inclusion" -> true;
            default ->
                throw InvalidInput.outside(
                        ValueProblem.VALUE_NOT_ALLOWED,
                        at + "properties.kind",
                        "exclusion or inclusion",
                        quoted(properties.kind()));
        };
        return geometry.shape(new AreaReader(at + "geometry", at + "properties.radius"), inside, properties.radius());
    }

    public AltitudeBand band() {
        return new AltitudeBandReader(at + "properties.")
                .band(properties.floor(), properties.ceiling(), properties.altitudeReference());
    }

    ZoneBinding binding() {
        if (properties.user() != null && properties.drone() != null) {
            throw new InvalidInput(
                    ValueProblem.VALUES_EXCLUSIVE,
                    at + "properties.user",
                    "a user or a drone",
                    "A zone binds a user or a drone, not both.");
        }
        if (properties.user() != null) {
            return new ZoneBinding.OfUser(properties.user());
        }
        return properties.drone() == null ? ZoneBinding.EVERYBODY : ofDrone(properties.drone());
    }

    private ZoneBinding ofDrone(String id) {
        try {
            return new ZoneBinding.OfDrone(new DroneId(id));
        } catch (IllegalArgumentException e) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_MALFORMED, at + "properties.drone", "the id of a drone", quoted(id));
        }
    }

    /** One that is over already would guard nothing. */
    ZoneValidity validity(Instant now) {
        Instant from = moment("from", properties.from());
        Instant until = moment("until", properties.until());
        if (from != null && until != null && !from.isBefore(until)) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_OUT_OF_RANGE, at + "properties.until", "after " + from, until);
        }
        if (until != null && !until.isAfter(now)) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_OUT_OF_RANGE, at + "properties.until", "later than now", until);
        }
        return new ZoneValidity(from, until);
    }

    private @Nullable Instant moment(String field, @Nullable String text) {
        if (text == null) {
            return null;
        }
        try {
            return OffsetDateTime.parse(text).toInstant();
        } catch (DateTimeException e) {
            throw InvalidInput.outside(ValueProblem.VALUE_MALFORMED, at + "properties." + field, MOMENT, quoted(text));
        }
    }

    BreachAction onBreach() {
        return switch (properties.onBreach() == null ? "hold" : properties.onBreach()) {
            case "hold" -> BreachAction.HOLD;
            case "returnToLaunch" -> BreachAction.RETURN_TO_LAUNCH;
            case "land" -> BreachAction.LAND;
            default ->
                throw InvalidInput.outside(
                        ValueProblem.VALUE_NOT_ALLOWED,
                        at + "properties.onBreach",
                        "hold, returnToLaunch or land",
                        quoted(properties.onBreach()));
        };
    }

    private static String quoted(@Nullable String text) {
        return text == null ? NOTHING : "\"" + text + "\"";
    }
}
