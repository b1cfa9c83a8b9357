package org.dronemap.store.postgres;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.store.StoreException;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** Mission items to JSON and back, spelled out so that a renamed record component never changes stored data. */
final class MissionItemJson {
    private static final JsonMapper MAPPER = JsonMapper.shared();

    private MissionItemJson() {}

    static String write(List<MissionItem> items) {
        ArrayNode array = MAPPER.createArrayNode();
        for (MissionItem item : items) {
            write(item, array.addObject());
        }
        return MAPPER.writeValueAsString(array);
    }

    static List<MissionItem> read(String json) {
        try {
            List<MissionItem> items = new ArrayList<>();
            for (JsonNode node : MAPPER.readTree(json)) {
                items.add(read(node));
            }
            return List.copyOf(items);
        } catch (JacksonException | IllegalArgumentException e) {
            throw new StoreException("A stored mission cannot be read: " + e.getMessage(), e);
        }
    }

    private static void write(MissionItem item, ObjectNode to) {
        if (item instanceof MissionItem.TakeOff takeOff) {
            to.put("type", "takeOff");
            putNumber(to, "altitudeMeters", takeOff.altitudeMeters());
        } else if (item instanceof MissionItem.Waypoint waypoint) {
            to.put("type", "waypoint");
            putNumber(to, "latitudeDegrees", waypoint.point().latitudeDegrees());
            putNumber(to, "longitudeDegrees", waypoint.point().longitudeDegrees());
            putNumber(to, "altitudeMeters", waypoint.altitude().meters());
            to.put("altitudeReference", word(waypoint.altitude().reference()));
            putNumber(to, "holdSeconds", waypoint.holdSeconds());
        } else if (item instanceof MissionItem.ReturnToLaunch) {
            to.put("type", "returnToLaunch");
        } else if (item instanceof MissionItem.Land) {
            to.put("type", "land");
        } else if (item instanceof MissionItem.Other other) {
            to.put("type", "other");
            to.put("description", other.description());
        } else {
            throw new IllegalArgumentException("no form for mission item " + item);
        }
    }

    private static MissionItem read(JsonNode node) {
        String type = node.required("type").stringValue();
        return switch (type) {
            case "takeOff" -> new MissionItem.TakeOff(number(node, "altitudeMeters"));
            case "waypoint" ->
                new MissionItem.Waypoint(
                        new Geodetic(number(node, "latitudeDegrees"), number(node, "longitudeDegrees")),
                        new Altitude(
                                number(node, "altitudeMeters"),
                                reference(node.required("altitudeReference").stringValue())),
                        number(node, "holdSeconds"));
            case "returnToLaunch" -> new MissionItem.ReturnToLaunch();
            case "land" -> new MissionItem.Land();
            case "other" -> new MissionItem.Other(node.required("description").stringValue());
            default -> throw new IllegalArgumentException("unknown mission item type \"" + type + "\"");
        };
    }

    private static String word(Altitude.Reference reference) {
        return switch (reference) {
            case HOME -> "home";
            case AMSL -> "amsl";
        };
    }

    private static Altitude.Reference reference(String word) {
        return switch (word) {
            case "home" -> Altitude.Reference.HOME;
            case "amsl" -> Altitude.Reference.AMSL;
            default -> throw new IllegalArgumentException("unknown altitude reference \"" + word + "\"");
        };
    }

    /** JSON has no NaN, but a vehicle's own items may carry it. */
    private static void putNumber(ObjectNode to, String field, double value) {
        if (Double.isFinite(value)) {
            to.put(field, value);
        } else {
            to.put(field, Double.toString(value));
        }
    }

    private static double number(JsonNode node, String field) {
        JsonNode value = node.required(field);
        return value.isString() ? Double.parseDouble(value.stringValue()) : value.doubleValue();
    }
}
