package org.dronemap.ws.zone;

import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.JsonCodec;
import org.dronemap.ws.reading.ObjectOnlyTypeResolver;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.DeserializationFeature;
import tools.jackson.databind.annotation.JsonTypeResolver;
import tools.jackson.databind.json.JsonMapper;

/** Reads zones from GeoJSON or KML files made by other programs: ignores what is unknown and splits multipolygons. */
final class ZoneImport {
    private static final JsonCodec LENIENT = new JsonCodec(JsonMapper.builder()
            .disable(DeserializationFeature.FAIL_ON_UNKNOWN_PROPERTIES)
            .build());
    private static final String TYPES = "FeatureCollection or Feature";

    private ZoneImport() {}

    /** Either a whole collection or one feature. */
    record Document(
            @Nullable String type,
            @Nullable List<@Nullable Feature> features,
            @Nullable Geometry geometry,
            ZoneFeature.@Nullable ZoneProperties properties) {}

    /** As others write them. */
    record Feature(
            @Nullable String type, @Nullable Geometry geometry, ZoneFeature.@Nullable ZoneProperties properties) {}

    /** Of one zone, or of several. */
    @JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "type")
    @JsonTypeResolver(ObjectOnlyTypeResolver.class)
    @JsonSubTypes({
        @JsonSubTypes.Type(ZoneGeometry.class),
        @JsonSubTypes.Type(value = MultiPolygon.class, name = "MultiPolygon")
    })
    sealed interface Geometry permits ZoneGeometry, MultiPolygon {}

    /** Several areas. */
    record MultiPolygon(@Nullable List<@Nullable List<List<List<Double>>>> coordinates) implements Geometry {}

    /** One zone to be, and where in the document it stands. */
    record Part(String at, ZoneFeature feature) {}

    static List<Part> parts(String text) {
        if (text.stripLeading().startsWith("<")) {
            return KmlZoneReader.parts(text);
        }
        Document document = LENIENT.read(text, Document.class);
        if ("Feature".equals(document.type())) {
            return parts("", new Feature("Feature", document.geometry(), document.properties()), 1);
        }
        if (!"FeatureCollection".equals(document.type())) {
            throw InvalidInput.outside(ValueProblem.VALUE_NOT_ALLOWED, "type", TYPES, String.valueOf(document.type()));
        }
        List<@Nullable Feature> features = document.features();
        if (features == null || features.isEmpty()) {
            throw InvalidInput.missing("features", "a list with at least one feature");
        }
        List<Part> read = new ArrayList<>();
        for (int i = 0; i < features.size(); i++) {
            Feature feature = features.get(i);
            if (feature == null) {
                throw InvalidInput.missing("features[" + i + "]", "a feature");
            }
            read.addAll(parts("features[" + i + "].", feature, i + 1));
        }
        return List.copyOf(read);
    }

    /** An area that is nothing but its rings and a name. */
    static ZoneFeature feature(List<List<List<Double>>> rings, String name) {
        return named(new Feature("Feature", null, null), new ZoneGeometry.Polygon(rings), name, "");
    }

    private static List<Part> parts(String at, Feature feature, int number) {
        if (!(feature.geometry() instanceof MultiPolygon several)) {
            ZoneGeometry shape = feature.geometry() instanceof ZoneGeometry one ? one : null;
            return List.of(new Part(at, named(feature, shape, "Zone " + number, "")));
        }
        List<@Nullable List<List<List<Double>>>> polygons = several.coordinates();
        if (polygons == null) {
            throw InvalidInput.missing(at + "geometry.coordinates", "a list of polygons");
        }
        List<Part> parts = new ArrayList<>();
        for (List<List<List<Double>>> polygon : polygons) {
            String part = polygons.size() > 1 ? " (" + (parts.size() + 1) + ")" : "";
            parts.add(new Part(at, named(feature, new ZoneGeometry.Polygon(polygon), "Zone " + number, part)));
        }
        return List.copyOf(parts);
    }

    private static ZoneFeature named(Feature feature, @Nullable ZoneGeometry shape, String fallback, String part) {
        ZoneFeature.ZoneProperties p = feature.properties();
        if (p == null) {
            p = new ZoneFeature.ZoneProperties(
                    null, null, null, null, null, null, null, null, null, null, null, null, null);
        }
        String name = p.name() == null || p.name().isBlank() ? fallback : p.name();
        return new ZoneFeature(
                feature.type(),
                null,
                shape,
                new ZoneFeature.ZoneProperties(
                        name + part,
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
