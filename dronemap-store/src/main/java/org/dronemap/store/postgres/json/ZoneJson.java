package org.dronemap.store.postgres.json;

import java.time.Instant;
import java.util.List;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.core.stored.StoredNames;
import org.dronemap.core.zone.BreachAction;
import org.dronemap.core.zone.Zone;
import org.dronemap.core.zone.ZoneBinding;
import org.dronemap.core.zone.ZoneValidity;
import org.dronemap.store.StoreException;
import org.jspecify.annotations.Nullable;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** Converts zones to JSON and back, for the database, spelled out so that renamed code never changes stored data. */
public final class ZoneJson {
    private static final JsonMapper MAPPER = JsonMapper.shared();

    private ZoneJson() {}

    public static String write(List<Zone> zones) {
        ArrayNode array = MAPPER.createArrayNode();
        zones.forEach(zone -> write(zone, array.addObject()));
        return MAPPER.writeValueAsString(array);
    }

    public static Zone read(String json) {
        try {
            return read(MAPPER.readTree(json));
        } catch (JacksonException | IllegalArgumentException e) {
            throw new StoreException("A stored zone cannot be read: " + e.getMessage(), e);
        }
    }

    private static void write(Zone zone, ObjectNode to) {
        to.put("id", zone.id());
        to.put("name", zone.name());
        ShapeJson.write(zone.shape(), to);
        ShapeJson.write(zone.band(), to);
        if (zone.binding() instanceof ZoneBinding.OfUser user) {
            to.put("user", user.name());
        } else if (zone.binding() instanceof ZoneBinding.OfDrone drone) {
            to.put("drone", drone.id().value());
        }
        to.put("from", text(zone.validity().from()));
        to.put("until", text(zone.validity().until()));
        to.put("onBreach", StoredNames.of(zone.onBreach()));
        to.put("changedBy", zone.changedBy());
        to.put("changedAt", zone.changedAt().toString());
        if (!zone.organisation().isHome()) {
            to.put("organisation", zone.organisation().value());
        }
    }

    private static @Nullable String text(@Nullable Instant moment) {
        return moment == null ? null : moment.toString();
    }

    private static Zone read(JsonNode from) {
        return new Zone(
                from.required("id").stringValue(),
                from.required("name").stringValue(),
                ShapeJson.shape(from),
                ShapeJson.band(from),
                binding(from),
                new ZoneValidity(moment(from, "from"), moment(from, "until")),
                StoredNames.constant(
                        BreachAction.class, from.required("onBreach").stringValue()),
                from.required("changedBy").stringValue(),
                Instant.parse(from.required("changedAt").stringValue()),
                from.has("organisation")
                        ? new OrganisationId(from.required("organisation").stringValue())
                        : OrganisationId.HOME);
    }

    private static ZoneBinding binding(JsonNode from) {
        if (from.has("user")) {
            return new ZoneBinding.OfUser(from.required("user").stringValue());
        }
        return from.has("drone")
                ? new ZoneBinding.OfDrone(new DroneId(from.required("drone").stringValue()))
                : ZoneBinding.EVERYBODY;
    }

    private static @Nullable Instant moment(JsonNode from, String field) {
        return from.hasNonNull(field) ? Instant.parse(from.required(field).stringValue()) : null;
    }
}
