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
            putPlace(to, waypoint.point(), waypoint.altitude());
            putNumber(to, "holdSeconds", waypoint.holdSeconds());
        } else if (item instanceof MissionItem.ReturnToLaunch) {
            to.put("type", "returnToLaunch");
        } else if (item instanceof MissionItem.Land) {
            to.put("type", "land");
        } else if (item instanceof MissionItem.Wait wait) {
            to.put("type", "wait");
            putNumber(to, "seconds", wait.seconds());
        } else if (item instanceof MissionItem.Action action) {
            write(action, to);
        } else if (item instanceof MissionItem.Other other) {
            to.put("type", "other");
            to.put("description", other.description());
        } else {
            throw new IllegalArgumentException("no form for mission item " + item);
        }
    }

    private static void write(MissionItem.Action action, ObjectNode to) {
        if (action instanceof MissionItem.TakePhoto) {
            to.put("type", "takePhoto");
        } else if (action instanceof MissionItem.SetServo servo) {
            to.put("type", "setServo");
            to.put("output", servo.output());
            to.put("pulseMicros", servo.pulseMicros());
        } else if (action instanceof MissionItem.LookAt look) {
            to.put("type", "lookAt");
            putPlace(to, look.point(), look.altitude());
        } else if (action instanceof MissionItem.LookAhead) {
            to.put("type", "lookAhead");
        } else {
            throw new IllegalArgumentException("no form for mission item " + action);
        }
    }

    private static void putPlace(ObjectNode to, Geodetic point, Altitude altitude) {
        putNumber(to, "latitudeDegrees", point.latitudeDegrees());
        putNumber(to, "longitudeDegrees", point.longitudeDegrees());
        putNumber(to, "altitudeMeters", altitude.meters());
        to.put("altitudeReference", word(altitude.reference()));
    }

    private static MissionItem read(JsonNode node) {
        String type = node.required("type").stringValue();
        return switch (type) {
            case "takeOff" -> new MissionItem.TakeOff(number(node, "altitudeMeters"));
            case "waypoint" -> new MissionItem.Waypoint(point(node), altitude(node), number(node, "holdSeconds"));
            case "returnToLaunch" -> new MissionItem.ReturnToLaunch();
            case "land" -> new MissionItem.Land();
            case "wait" -> new MissionItem.Wait(number(node, "seconds"));
            case "takePhoto" -> new MissionItem.TakePhoto();
            case "setServo" ->
                new MissionItem.SetServo(
                        node.required("output").intValue(),
                        node.required("pulseMicros").intValue());
            case "lookAt" -> new MissionItem.LookAt(point(node), altitude(node));
            case "lookAhead" -> new MissionItem.LookAhead();
            case "other" -> new MissionItem.Other(node.required("description").stringValue());
            default -> throw new IllegalArgumentException("unknown mission item type \"" + type + "\"");
        };
    }

    private static Geodetic point(JsonNode node) {
        return new Geodetic(number(node, "latitudeDegrees"), number(node, "longitudeDegrees"));
    }

    private static Altitude altitude(JsonNode node) {
        return new Altitude(
                number(node, "altitudeMeters"),
                reference(node.required("altitudeReference").stringValue()));
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
