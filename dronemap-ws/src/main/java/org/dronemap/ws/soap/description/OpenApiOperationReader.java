package org.dronemap.ws.soap.description;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronemap.ws.soap.description.SoapOperation.Answer;
import org.dronemap.ws.soap.description.SoapOperation.Argument;
import org.dronemap.ws.soap.description.SoapOperation.Body;
import org.dronemap.ws.soap.description.SoapOperation.Fixed;
import org.dronemap.ws.soap.description.SoapOperation.Place;
import org.dronemap.ws.soap.xml.XmlMember;
import org.dronemap.ws.soap.xml.XmlType;
import org.dronemap.ws.soap.xml.XmlTypes;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.JsonNode;

/** Derives the SOAP services and operations from the server's OpenAPI description, one for each operation of REST. */
public final class OpenApiOperationReader {
    private static final String API = "/api/v1";
    private static final String JSON = "application/json";
    private static final Pattern VARIABLE = Pattern.compile("/([a-z-]+)/\\{id}");

    private final XmlTypes types;
    private final JsonNode openApi;
    private final Map<String, List<SoapOperation>> found = new TreeMap<>();
    private final Map<String, String> without = new TreeMap<>();

    private OpenApiOperationReader(JsonNode openApi) {
        this.openApi = openApi;
        this.types = OpenApiTypeReader.read(openApi);
    }

    public static SoapServices read(JsonNode openApi) {
        OpenApiOperationReader reader = new OpenApiOperationReader(openApi);
        reader.readAll();
        Map<String, SoapService> services = new LinkedHashMap<>();
        reader.found.forEach((name, operations) -> services.put(name, service(name, operations)));
        SoapServices.OTHER_NAMES.forEach((other, name) ->
                services.computeIfAbsent(other, it -> service(it, reader.found.getOrDefault(name, List.of()))));
        return new SoapServices(services, reader.types, reader.without);
    }

    private static SoapService service(String name, List<SoapOperation> operations) {
        Map<String, SoapOperation> byName = new TreeMap<>();
        for (SoapOperation operation : operations) {
            SoapOperation other = byName.put(operation.name(), operation);
            if (other != null) {
                throw new IllegalStateException("SOAP would have two operations " + name + "." + operation.name()
                        + ": of " + other.of().id() + " and of "
                        + operation.of().id() + "; name one of them by @SoapName.");
            }
        }
        return SoapServices.named(name, List.copyOf(byName.values()));
    }

    private void readAll() {
        openApi.path("paths")
                .properties()
                .forEach(path -> path.getValue().properties().forEach(method -> {
                    JsonNode operation = method.getValue();
                    var of = new SoapOperation.RestAddress(
                            operation.path("operationId").asString(),
                            method.getKey().toUpperCase(Locale.ROOT),
                            path.getKey());
                    String reason = operation.path("x-without-soap").asString("");
                    if (!reason.isEmpty()) {
                        without.put(of.id(), reason);
                    } else if (path.getKey().startsWith(API)) {
                        String tag = operation.path("tags").path(0).asString("Server");
                        found.computeIfAbsent(SoapServices.serviceOf(tag), service -> new ArrayList<>())
                                .addAll(operations(of, operation));
                    }
                }));
    }

    private List<SoapOperation> operations(SoapOperation.RestAddress of, JsonNode operation) {
        List<Argument> arguments = operation
                .path("parameters")
                .valueStream()
                .filter(one -> !one.path("in").asString().equals("cookie"))
                .map(one -> argument(of.path(), one))
                .toList();
        String words = operation.path("summary").asString("");
        Optional<Answer> answer = answer(operation.path("responses"));
        XmlTypes.Alternatives alternatives = alternatives(operation);
        if (alternatives != null) {
            Map<String, String> names = new HashMap<>();
            operation
                    .path("x-soap-names")
                    .properties()
                    .forEach(one -> names.put(one.getKey(), one.getValue().asString()));
            List<SoapOperation> each = new ArrayList<>();
            alternatives.kinds().forEach((kind, type) -> {
                Body body =
                        new Body.Members(types.structure(type), true, new Fixed(alternatives.discriminator(), kind));
                each.add(checked(new SoapOperation(
                        names.getOrDefault(kind, kind),
                        of,
                        arguments,
                        body,
                        answer.orElse(null),
                        words + ": " + kind)));
            });
            return each;
        }
        String name = operation.path("x-soap-name").asString(of.id());
        return List.of(checked(new SoapOperation(name, of, arguments, body(operation), answer.orElse(null), words)));
    }

    private static SoapOperation checked(SoapOperation operation) {
        long names =
                operation.elements().stream().map(XmlMember::name).distinct().count();
        if (names < operation.elements().size()) {
            throw new IllegalStateException("a parameter and a member of the body of "
                    + operation.of().id() + " have the same name; call one of them otherwise.");
        }
        return operation;
    }

    private static Argument argument(String path, JsonNode described) {
        String inRest = described.path("name").asString();
        Place place = described.path("in").asString().equals("path") ? Place.PATH : Place.QUERY;
        String name = place == Place.PATH && inRest.equals("id") ? nameOfId(path) : inRest;
        XmlMember member = new XmlMember(
                name,
                OpenApiTypeReader.type(described.path("schema")),
                described.path("required").asBoolean(false),
                false,
                described.path("description").asString(""));
        return new Argument(member, place, inRest);
    }

    /** {@code /drones/{id}}: {@code droneId}. */
    private static String nameOfId(String path) {
        Matcher variable = VARIABLE.matcher(path);
        if (!variable.find()) {
            return "id";
        }
        StringBuilder name = new StringBuilder();
        for (String word : variable.group(1).split("-", -1)) {
            name.append(
                            name.isEmpty()
                                    ? word.substring(0, 1)
                                    : word.substring(0, 1).toUpperCase(Locale.ROOT))
                    .append(word.substring(1));
        }
        String many = name.toString();
        return (many.endsWith("s") ? many.substring(0, many.length() - 1) : many) + "Id";
    }

    private XmlTypes.@Nullable Alternatives alternatives(JsonNode operation) {
        return OpenApiTypeReader.reference(bodySchema(operation))
                .map(types::get)
                .filter(XmlTypes.Alternatives.class::isInstance)
                .map(XmlTypes.Alternatives.class::cast)
                .orElse(null);
    }

    private static JsonNode bodySchema(JsonNode operation) {
        return operation.path("requestBody").path("content").path(JSON).path("schema");
    }

    private @Nullable Body body(JsonNode operation) {
        JsonNode request = operation.path("requestBody");
        if (request.isMissingNode()) {
            return null;
        }
        Optional<String> named = OpenApiTypeReader.reference(bodySchema(operation));
        if (named.isPresent()) {
            return new Body.Members(
                    types.structure(named.get()), request.path("required").asBoolean(false), null);
        }
        String mediaType =
                request.path("content").properties().iterator().next().getKey();
        return new Body.File(mediaType);
    }

    /** Of the first success that has one; each success of an operation answers with the same. */
    private static Optional<Answer> answer(JsonNode responses) {
        return responses.properties().stream()
                .filter(one -> one.getKey().startsWith("2"))
                .flatMap(one -> one.getValue().path("content").properties().stream())
                .findFirst()
                .map(content -> {
                    JsonNode schema = content.getValue().path("schema");
                    boolean json = content.getKey().equals(JSON)
                            && !OpenApiTypeReader.type(schema).equals(XmlType.Text.of("base64Binary"));
                    return json
                            ? new Answer(OpenApiTypeReader.type(schema), true, OpenApiTypeReader.isNullable(schema))
                            : new Answer(XmlType.Text.of("base64Binary"), false, false);
                });
    }
}
