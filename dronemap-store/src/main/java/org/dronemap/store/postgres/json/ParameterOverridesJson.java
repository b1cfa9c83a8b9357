package org.dronemap.store.postgres.json;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.parameter.OverriddenParameter;
import org.dronemap.store.StoreException;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;

/** Converts overridden parameter values of drones' owners to JSON and back, for the database. */
public final class ParameterOverridesJson {
    private static final JsonMapper MAPPER = JsonMapper.shared();

    private ParameterOverridesJson() {}

    public static String write(List<OverriddenParameter> values) {
        ArrayNode array = MAPPER.createArrayNode();
        values.forEach(value -> array.addObject()
                .put("name", value.name())
                .put("owners", value.owners())
                .put("ours", value.ours())
                .put("bits", value.bits()));
        return MAPPER.writeValueAsString(array);
    }

    public static List<OverriddenParameter> read(String json) {
        try {
            List<OverriddenParameter> values = new ArrayList<>();
            MAPPER.readTree(json).forEach(one -> values.add(read(one)));
            return values;
        } catch (JacksonException e) {
            throw new StoreException("Stored values of a drone's owner cannot be read: " + e.getMessage(), e);
        }
    }

    private static OverriddenParameter read(JsonNode from) {
        return new OverriddenParameter(
                from.required("name").stringValue(),
                from.required("owners").doubleValue(),
                from.required("ours").doubleValue(),
                from.required("bits").longValue());
    }
}
