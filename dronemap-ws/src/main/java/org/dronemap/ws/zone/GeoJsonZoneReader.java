package org.dronemap.ws.zone;

import java.util.List;
import java.util.Map;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.JsonCodec;
import org.jspecify.annotations.Nullable;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.json.JsonReadFeature;
import tools.jackson.databind.DeserializationFeature;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.MissingNode;

/**
 * Reads the areas of a GeoJSON file as zones, feature by feature; members of other programs are ignored. Used once, by
 * one thread.
 */
final class GeoJsonZoneReader {
    private static final JsonMapper MAPPER = JsonMapper.builder()
            .disable(DeserializationFeature.FAIL_ON_UNKNOWN_PROPERTIES)
            // Python writes NaN, which is no JSON; it concerns its own feature alone.
            .enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS)
            // Feature by feature, each with others behind it.
            .disable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
            .build();
    private static final String TYPES = "FeatureCollection or Feature";

    private final ZoneFile file = new ZoneFile();
    private @Nullable String type;
    private int features = -1;
    private @Nullable JsonNode geometry;
    private @Nullable JsonNode properties;

    private GeoJsonZoneReader() {}

    static ZoneFile read(String text) {
        GeoJsonZoneReader reader = new GeoJsonZoneReader();
        try (JsonParser parser = MAPPER.createParser(text)) {
            if (parser.nextToken() != JsonToken.START_OBJECT) {
                throw new InvalidInput(
                        ValueProblem.FILE_UNUSABLE, "file", TYPES, "This is neither GeoJSON nor KML nor KMZ.");
            }
            while (parser.nextToken() == JsonToken.PROPERTY_NAME) {
                reader.member(parser.currentName(), parser);
            }
            if (parser.nextToken() != null) {
                throw new InvalidInput(
                        ValueProblem.FILE_UNUSABLE, "file", TYPES, "There is something behind the end of the GeoJSON.");
            }
        } catch (JacksonException e) {
            throw JsonCodec.rejection(e);
        }
        reader.end();
        return reader.file;
    }

    private void member(String name, JsonParser parser) {
        JsonToken value = parser.nextToken();
        switch (name) {
            case "type" -> type = value == JsonToken.VALUE_STRING ? parser.getString() : String.valueOf(value);
            case "geometry" -> geometry = MAPPER.readTree(parser);
            case "properties" -> properties = MAPPER.readTree(parser);
            case "crs" -> GeoJsonReferenceSystem.check(MAPPER.readTree(parser));
            case "features" -> {
                if (value != JsonToken.START_ARRAY) {
                    throw InvalidInput.missing("features", "a list with at least one feature");
                }
                features = 0;
                while (parser.nextToken() != JsonToken.END_ARRAY) {
                    JsonNode feature = MAPPER.readTree(parser);
                    feature("features[" + features + "]", feature, ++features);
                }
            }
            default -> parser.skipChildren();
        }
    }

    private void end() {
        if ("Feature".equals(type)) {
            area(new Piece("", text(properties), 1, properties), "geometry", geometry);
        } else if (!"FeatureCollection".equals(type)) {
            throw InvalidInput.outside(ValueProblem.VALUE_NOT_ALLOWED, "type", TYPES, String.valueOf(type));
        } else if (features < 1) {
            throw InvalidInput.missing("features", "a list with at least one feature");
        }
    }

    /** Name, number and properties that all areas of one feature have in common; {@code at} ends with a point. */
    private record Piece(
            String at,
            @Nullable String name,
            int number,
            @Nullable JsonNode properties) {
        String where() {
            return at.isEmpty() ? "feature" : at.substring(0, at.length() - 1);
        }
    }

    private void feature(String at, JsonNode feature, int number) {
        String name = text(feature.get("properties"));
        if (!feature.isObject() || !"Feature".equals(feature.path("type").stringValue(null))) {
            file.leaveOut(at, name, InvalidInput.missing(at, "a Feature"));
            return;
        }
        area(new Piece(at + ".", name, number, feature.get("properties")), "geometry", feature.get("geometry"));
    }

    private static @Nullable String text(@Nullable JsonNode properties) {
        JsonNode name = properties == null ? null : named(properties);
        return name == null || name.isNull() || !name.isValueNode() ? null : name.asString();
    }

    /** Programs write NAME and Name as well. */
    private static @Nullable JsonNode named(JsonNode properties) {
        JsonNode exact = properties.get("name");
        return exact != null || !properties.isObject()
                ? exact
                : properties
                        .propertyStream()
                        .filter(each -> each.getKey().equalsIgnoreCase("name"))
                        .findFirst()
                        .map(Map.Entry::getValue)
                        .orElse(null);
    }

    private void area(Piece piece, String field, @Nullable JsonNode given) {
        String at = piece.at() + field;
        JsonNode shape = given == null ? MissingNode.getInstance() : given;
        String kind = shape.path("type").stringValue(null);
        try {
            switch (kind == null ? "" : kind) {
                case "" -> throw InvalidInput.missing(at, "a geometry");
                case "Polygon" -> zones(piece, at, List.of(shape.path("coordinates")), false);
                case "MultiPolygon" -> zones(piece, at, children(shape.path("coordinates"), at), true);
                case "Point" -> circle(piece, at, shape.path("coordinates"));
                case "GeometryCollection" -> {
                    List<JsonNode> parts = children(shape.path("geometries"), at);
                    for (int i = 0; i < parts.size(); i++) {
                        area(piece, field + ".geometries[" + i + "]", parts.get(i));
                    }
                }
                default ->
                    throw InvalidInput.outside(
                            ValueProblem.VALUE_NOT_ALLOWED,
                            at + ".type",
                            "Polygon, MultiPolygon, or Point with a radius",
                            "\"" + kind + "\"");
            }
        } catch (InvalidInput e) {
            file.leaveOut(piece.where(), piece.name(), e);
        }
    }

    private static List<JsonNode> children(JsonNode list, String at) {
        if (!list.isArray()) {
            throw InvalidInput.missing(at + ".coordinates", "a list");
        }
        if (list.isEmpty()) {
            throw InvalidInput.missing(at, "a geometry with at least one area");
        }
        return list.valueStream().toList();
    }

    private void circle(Piece piece, String at, JsonNode middle) {
        JsonNode radius = piece.properties() == null ? null : piece.properties().get("radius");
        if (radius == null || radius.isNull()) {
            throw InvalidInput.missing(piece.at() + "properties.radius", "1 to 100000 m, for a Point is no area");
        }
        GeoJsonPositions positions = new GeoJsonPositions(at + ".coordinates");
        add(piece, new ZoneGeometry.Point(positions.position(middle)), 0, positions);
    }

    private void zones(Piece piece, String at, List<JsonNode> polygons, boolean several) {
        for (int i = 0; i < polygons.size(); i++) {
            String field = at + ".coordinates" + (polygons.size() > 1 ? "[" + i + "]" : "");
            try {
                GeoJsonPositions positions = new GeoJsonPositions(field);
                ZoneGeometry shape = new ZoneGeometry.Polygon(positions.rings(polygons.get(i)));
                add(piece, shape, several && polygons.size() > 1 ? i + 1 : 0, positions);
            } catch (InvalidInput e) {
                file.leaveOut(piece.where(), piece.name(), e);
            }
        }
    }

    private void add(Piece piece, ZoneGeometry shape, int number, GeoJsonPositions positions) {
        ZoneFileName name = ZoneFileName.of(piece.name(), "Zone " + piece.number());
        file.add(piece.at(), feature(shape, name.numbered(number), known(piece)));
        name.cut(piece.at() + "properties.name").ifPresent(why -> file.leaveOut(piece.where(), name.whole(), why));
        if (positions.hasHeights()) {
            file.leaveOutHeights(piece.where(), name.whole(), positions.lowest(), positions.highest());
        }
    }

    private static ZoneFeature.ZoneProperties known(Piece piece) {
        JsonNode written = piece.properties();
        if (written == null || written.isNull()) {
            return ZoneFeature.ZoneProperties.NONE;
        }
        try {
            return MAPPER.treeToValue(written, ZoneFeature.ZoneProperties.class);
        } catch (JacksonException e) {
            Rejection why = JsonCodec.rejection(e);
            throw why instanceof InvalidInput input
                    ? input.within(piece.at() + "properties.")
                    : InvalidInput.missing(piece.at() + "properties", "an object");
        }
    }

    /** An area with what its file says of it, but for what the server gives. */
    static ZoneFeature feature(ZoneGeometry shape, String name, ZoneFeature.ZoneProperties p) {
        return new ZoneFeature(
                "Feature",
                null,
                shape,
                new ZoneFeature.ZoneProperties(
                        name,
                        p.kind(),
                        p.radius(),
                        p.floor(),
                        p.ceiling(),
                        p.altitudeReference(),
                        p.user(),
                        p.drone(),
                        p.from(),
                        p.until(),
                        p.onBreach(),
                        null,
                        null));
    }
}
