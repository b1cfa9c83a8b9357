package org.dronemap.store.postgres.json;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.LandingPlace;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.store.StoreException;
import org.jspecify.annotations.Nullable;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** Converts mission items to JSON and back, for the database, so that renamed code never changes stored data. */
public final class MissionItemJson {
    private static final JsonMapper MAPPER = JsonMapper.shared();

    private MissionItemJson() {}

    public static String write(List<MissionItem> items) {
        ArrayNode array = MAPPER.createArrayNode();
        for (MissionItem item : items) {
            write(item, array.addObject());
        }
        return MAPPER.writeValueAsString(array);
    }

    public static List<MissionItem> read(String json) {
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
        to.put("type", item.kind().word());
        switch (item.kind()) {
            case TAKE_OFF -> putNumber(to, "altitudeMeters", ((MissionItem.TakeOff) item).altitudeMeters());
            case WAYPOINT -> {
                MissionItem.Waypoint waypoint = (MissionItem.Waypoint) item;
                putPlace(to, waypoint.point(), waypoint.altitude());
                putNumber(to, "holdSeconds", waypoint.holdSeconds());
            }
            case WAIT -> putNumber(to, "seconds", ((MissionItem.Wait) item).seconds());
            case SET_SERVO -> {
                MissionItem.SetServo servo = (MissionItem.SetServo) item;
                to.put("output", servo.output());
                to.put("pulseMicros", servo.pulseMicros());
            }
            case LOOK_AT -> putPlace(to, ((MissionItem.LookAt) item).point(), ((MissionItem.LookAt) item).altitude());
            case OTHER -> to.put("description", ((MissionItem.Other) item).description());
            case LAND -> putLanding(to, ((MissionItem.Land) item).place());
            case RETURN_TO_LAUNCH, TAKE_PHOTO, LOOK_AHEAD -> {}
        }
    }

    private static void putLanding(ObjectNode to, @Nullable LandingPlace place) {
        if (place != null) {
            putPlace(to, place.point(), place.ground());
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
        MissionItem.Kind kind = MissionItem.Kind.named(type)
                .orElseThrow(() -> new IllegalArgumentException("unknown mission item type \"" + type + "\""));
        return switch (kind) {
            case TAKE_OFF -> new MissionItem.TakeOff(number(node, "altitudeMeters"));
            case WAYPOINT -> new MissionItem.Waypoint(point(node), altitude(node), number(node, "holdSeconds"));
            case RETURN_TO_LAUNCH -> new MissionItem.ReturnToLaunch();
            case LAND ->
                new MissionItem.Land(
                        node.has("latitudeDegrees") ? new LandingPlace(point(node), altitude(node)) : null);
            case WAIT -> new MissionItem.Wait(number(node, "seconds"));
            case TAKE_PHOTO -> new MissionItem.TakePhoto();
            case SET_SERVO ->
                new MissionItem.SetServo(
                        node.required("output").intValue(),
                        node.required("pulseMicros").intValue());
            case LOOK_AT -> new MissionItem.LookAt(point(node), altitude(node));
            case LOOK_AHEAD -> new MissionItem.LookAhead();
            case OTHER -> new MissionItem.Other(node.required("description").stringValue());
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
