package org.dronemap.store.postgres.json;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.zone.FlightBounds;
import org.dronemap.store.StoreException;
import org.jspecify.annotations.Nullable;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** Converts the flight bounds of an access key to JSON and back, for the database; null: there are none. */
public final class FlightBoundsJson {
    private static final JsonMapper MAPPER = JsonMapper.shared();

    private FlightBoundsJson() {}

    public static @Nullable String write(List<FlightBounds> bounds) {
        if (bounds.isEmpty()) {
            return null;
        }
        ArrayNode array = MAPPER.createArrayNode();
        bounds.forEach(one -> write(one, array.addObject()));
        return MAPPER.writeValueAsString(array);
    }

    private static void write(FlightBounds bounds, ObjectNode to) {
        FenceArea area = bounds.area();
        if (area != null) {
            ShapeJson.write(area, to.putObject("area"));
        }
        ShapeJson.write(bounds.band(), to);
    }

    public static List<FlightBounds> read(@Nullable String json) {
        if (json == null) {
            return List.of();
        }
        try {
            List<FlightBounds> bounds = new ArrayList<>();
            MAPPER.readTree(json).forEach(one -> bounds.add(read(one)));
            return bounds;
        } catch (JacksonException | IllegalArgumentException e) {
            throw new StoreException("Stored bounds of an access key cannot be read: " + e.getMessage(), e);
        }
    }

    private static FlightBounds read(JsonNode from) {
        return new FlightBounds(from.has("area") ? ShapeJson.shape(from.required("area")) : null, ShapeJson.band(from));
    }
}
