package org.dronemap.store.postgres;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceZone;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.core.zone.AltitudeBand;
import org.dronemap.core.zone.Binding;
import org.dronemap.core.zone.BreachAction;
import org.dronemap.core.zone.Validity;
import org.dronemap.core.zone.Zone;
import org.dronemap.store.StoreException;
import org.jspecify.annotations.Nullable;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** Zones to JSON and back, spelled out so that a renamed record component never changes stored data. */
final class ZoneJson {
    private static final JsonMapper MAPPER = JsonMapper.shared();

    private ZoneJson() {}

    static String write(List<Zone> zones) {
        ArrayNode array = MAPPER.createArrayNode();
        zones.forEach(zone -> write(zone, array.addObject()));
        return MAPPER.writeValueAsString(array);
    }

    static Zone read(String json) {
        try {
            return read(MAPPER.readTree(json));
        } catch (JacksonException | IllegalArgumentException e) {
            throw new StoreException("A stored zone cannot be read: " + e.getMessage(), e);
        }
    }

    private static void write(Zone zone, ObjectNode to) {
        to.put("id", zone.id());
        to.put("name", zone.name());
        to.put("inside", zone.shape().inside());
        if (zone.shape() instanceof FenceZone.Circle circle) {
            point(circle.center(), to.putObject("center"));
            to.put("radiusMeters", circle.radiusMeters());
        } else if (zone.shape() instanceof FenceZone.Polygon polygon) {
            ArrayNode corners = to.putArray("corners");
            polygon.corners().forEach(corner -> point(corner, corners.addObject()));
        }
        to.put("floorMeters", zone.band().floorMeters());
        to.put("ceilingMeters", zone.band().ceilingMeters());
        to.put("altitudeReference", zone.band().reference().name());
        if (zone.binding() instanceof Binding.OfUser user) {
            to.put("user", user.name());
        } else if (zone.binding() instanceof Binding.OfDrone drone) {
            to.put("drone", drone.id().value());
        }
        to.put("from", text(zone.validity().from()));
        to.put("until", text(zone.validity().until()));
        to.put("onBreach", zone.onBreach().name());
        to.put("changedBy", zone.changedBy());
        to.put("changedAt", zone.changedAt().toString());
        if (!zone.organisation().isHome()) {
            to.put("organisation", zone.organisation().value());
        }
    }

    private static void point(Geodetic point, ObjectNode to) {
        to.put("latitudeDegrees", point.latitudeDegrees());
        to.put("longitudeDegrees", point.longitudeDegrees());
    }

    private static @Nullable String text(@Nullable Instant moment) {
        return moment == null ? null : moment.toString();
    }

    private static Zone read(JsonNode from) {
        return new Zone(
                from.required("id").stringValue(),
                from.required("name").stringValue(),
                shape(from),
                new AltitudeBand(
                        number(from, "floorMeters"),
                        number(from, "ceilingMeters"),
                        Altitude.Reference.valueOf(
                                from.required("altitudeReference").stringValue())),
                binding(from),
                new Validity(moment(from, "from"), moment(from, "until")),
                BreachAction.valueOf(from.required("onBreach").stringValue()),
                from.required("changedBy").stringValue(),
                Instant.parse(from.required("changedAt").stringValue()),
                from.has("organisation")
                        ? new OrganisationId(from.required("organisation").stringValue())
                        : OrganisationId.HOME);
    }

    private static FenceZone shape(JsonNode from) {
        boolean inside = from.required("inside").booleanValue();
        if (from.has("center")) {
            return new FenceZone.Circle(
                    inside,
                    point(from.required("center")),
                    from.required("radiusMeters").doubleValue());
        }
        List<Geodetic> corners = new ArrayList<>();
        from.required("corners").forEach(corner -> corners.add(point(corner)));
        return new FenceZone.Polygon(inside, corners);
    }

    private static Geodetic point(JsonNode from) {
        return new Geodetic(
                from.required("latitudeDegrees").doubleValue(),
                from.required("longitudeDegrees").doubleValue());
    }

    private static Binding binding(JsonNode from) {
        if (from.has("user")) {
            return new Binding.OfUser(from.required("user").stringValue());
        }
        return from.has("drone")
                ? new Binding.OfDrone(new DroneId(from.required("drone").stringValue()))
                : Binding.EVERYBODY;
    }

    private static @Nullable Double number(JsonNode from, String field) {
        return from.hasNonNull(field) ? Double.valueOf(from.required(field).doubleValue()) : null;
    }

    private static @Nullable Instant moment(JsonNode from, String field) {
        return from.hasNonNull(field) ? Instant.parse(from.required(field).stringValue()) : null;
    }
}
