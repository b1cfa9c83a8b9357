package org.dronemap.store.postgres.json;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.mission.FenceZone;
import org.dronemap.core.zone.Bounds;
import org.dronemap.store.StoreException;
import org.jspecify.annotations.Nullable;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** Converts the flight bounds of an access key to JSON and back, for the database; null: there are none. */
public final class BoundsJson {
    private static final JsonMapper MAPPER = JsonMapper.shared();

    private BoundsJson() {}

    public static @Nullable String write(List<Bounds> bounds) {
        if (bounds.isEmpty()) {
            return null;
        }
        ArrayNode array = MAPPER.createArrayNode();
        bounds.forEach(one -> write(one, array.addObject()));
        return MAPPER.writeValueAsString(array);
    }

    private static void write(Bounds bounds, ObjectNode to) {
        FenceZone area = bounds.area();
        if (area != null) {
            ShapeJson.write(area, to.putObject("area"));
        }
        ShapeJson.write(bounds.band(), to);
    }

    public static List<Bounds> read(@Nullable String json) {
        if (json == null) {
            return List.of();
        }
        try {
            List<Bounds> bounds = new ArrayList<>();
            MAPPER.readTree(json).forEach(one -> bounds.add(read(one)));
            return bounds;
        } catch (JacksonException | IllegalArgumentException e) {
            throw new StoreException("Stored bounds of an access key cannot be read: " + e.getMessage(), e);
        }
    }

    private static Bounds read(JsonNode from) {
        return new Bounds(from.has("area") ? ShapeJson.shape(from.required("area")) : null, ShapeJson.band(from));
    }
}
