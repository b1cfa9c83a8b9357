package org.dronemap.ws.soap.description;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.dronemap.ws.soap.xml.XmlMember;
import org.dronemap.ws.soap.xml.XmlType;
import org.dronemap.ws.soap.xml.XmlTypes;
import tools.jackson.databind.JsonNode;

/** Derives the XML types of SOAP from the schemas of the server's OpenAPI description. */
final class OpenApiTypeReader {
    private static final String SCHEMAS = "#/components/schemas/";

    private static final String NULL = "null";
    private static final Set<String> PLAIN = Set.of("string", "number", "boolean");

    private OpenApiTypeReader() {}

    static XmlTypes read(JsonNode openApi) {
        Map<String, XmlTypes.Complex> named = new LinkedHashMap<>();
        openApi.path("components").path("schemas").properties().forEach(one -> {
            if (isComplex(one.getValue())) {
                named.put(one.getKey(), complex(one.getValue()));
            }
        });
        named.values().stream()
                .filter(XmlTypes.Alternatives.class::isInstance)
                .map(XmlTypes.Alternatives.class::cast)
                .toList()
                .forEach(one -> one.kinds()
                        .values()
                        .forEach(kind ->
                                named.computeIfPresent(kind, (name, type) -> without(type, one.discriminator()))));
        return new XmlTypes(named);
    }

    /** In XML the name of the element says which alternative it is. */
    private static XmlTypes.Complex without(XmlTypes.Complex type, String member) {
        return type instanceof XmlTypes.Structure structure
                ? new XmlTypes.Structure(
                        structure.members().stream()
                                .filter(one -> !one.name().equals(member))
                                .toList(),
                        structure.words())
                : type;
    }

    private static boolean isComplex(JsonNode schema) {
        return schema.has("properties")
                || schema.has("discriminator")
                || typeOf(schema).equals("object");
    }

    private static XmlTypes.Complex complex(JsonNode schema) {
        String words = schema.path("description").asString("");
        if (schema.has("discriminator")) {
            JsonNode told = schema.path("discriminator");
            Map<String, String> kinds = new LinkedHashMap<>();
            told.path("mapping")
                    .properties()
                    .forEach(kind ->
                            kinds.put(kind.getKey(), nameOf(kind.getValue().asString())));
            return new XmlTypes.Alternatives(told.path("propertyName").asString(), kinds, words);
        }
        Set<String> required =
                schema.path("required").valueStream().map(JsonNode::asString).collect(Collectors.toSet());
        List<XmlMember> members = new ArrayList<>();
        schema.path("properties")
                .properties()
                .forEach(one -> members.add(member(one.getKey(), one.getValue(), required.contains(one.getKey()))));
        return new XmlTypes.Structure(List.copyOf(members), words);
    }

    static XmlMember member(String name, JsonNode schema, boolean required) {
        return new XmlMember(
                name,
                type(schema),
                required,
                isNullable(schema),
                schema.path("description").asString(""));
    }

    static boolean isNullable(JsonNode schema) {
        return schema.path("type").valueStream().anyMatch(one -> one.asString().equals(NULL))
                || alternatives(schema).stream().anyMatch(one -> typeOf(one).equals(NULL));
    }

    private static List<JsonNode> alternatives(JsonNode schema) {
        return schema.path("anyOf").valueStream().toList();
    }

    static XmlType type(JsonNode schema) {
        Optional<String> named = reference(schema);
        if (named.isPresent()) {
            return new XmlType.Named(named.get());
        }
        List<JsonNode> real = alternatives(schema).stream()
                .filter(one -> !typeOf(one).equals(NULL))
                .toList();
        if (real.size() == 1) {
            return type(real.get(0));
        }
        return switch (typeOf(schema)) {
            case "array" -> new XmlType.Listed(type(schema.path("items")));
            case "object" -> new XmlType.Mapped(type(schema.path("additionalProperties")));
            case "boolean" -> XmlType.Text.of("boolean");
            case "integer" -> XmlType.Text.of(schema.path("format").asString("").equals("int64") ? "long" : "int");
            case "number" -> XmlType.Text.of("double");
            case "string" -> text(schema);
            default -> plain(schema);
        };
    }

    private static XmlType plain(JsonNode schema) {
        JsonNode either = schema.path("oneOf");
        if (either.isEmpty() || !either.valueStream().allMatch(one -> PLAIN.contains(typeOf(one)))) {
            throw new IllegalStateException("XML needs the type of what is described as " + schema);
        }
        return new XmlType.Plain();
    }

    private static XmlType text(JsonNode schema) {
        List<String> values = schema.path("enum")
                .valueStream()
                .filter(JsonNode::isString)
                .map(JsonNode::asString)
                .toList();
        return switch (schema.path("format").asString("")) {
            case "date-time" -> XmlType.Text.of("dateTime");
            case "byte", "binary" -> XmlType.Text.of("base64Binary");
            default -> new XmlType.Text("string", values);
        };
    }

    static Optional<String> reference(JsonNode schema) {
        return schema.has("$ref") ? Optional.of(nameOf(schema.path("$ref").asString())) : Optional.empty();
    }

    private static String nameOf(String reference) {
        return reference.startsWith(SCHEMAS) ? reference.substring(SCHEMAS.length()) : reference;
    }

    /** The one that is not null. */
    private static String typeOf(JsonNode schema) {
        JsonNode type = schema.path("type");
        if (type.isString()) {
            return type.asString();
        }
        return type.valueStream()
                .map(JsonNode::asString)
                .filter(one -> !one.equals(NULL))
                .findFirst()
                .orElse("");
    }
}
