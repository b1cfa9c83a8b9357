package org.dronemap.ws.stream.description;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import org.dronemap.ws.reading.JsonCodec;
import org.dronemap.ws.stream.StreamFace;
import org.dronemap.ws.stream.StreamMessage;
import org.dronemap.ws.stream.StreamMessageCatalogue;
import org.dronemap.ws.stream.StreamRequestCatalogue;
import org.dronemap.ws.stream.StreamServer;
import org.dronemap.ws.stream.StreamTopic;
import org.dronemap.ws.stream.delivery.PublishSchedule;
import org.jspecify.annotations.Nullable;
import org.springdoc.core.customizers.OpenApiCustomizer;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** Writes the AsyncAPI 3 description of the WebSocket stream: its topics, messages and requests. Any thread. */
public final class StreamDescription {
    private static final String CHANNEL = "#/channels/stream";

    private final List<StreamTopic<?>> topics;
    private final StreamMessageCatalogue said;
    private final StreamRequestCatalogue requests;
    private final List<OpenApiCustomizer> customizers;
    private final JsonMapper json;
    private final String version;
    /** Null until it is asked for. */
    private volatile @Nullable ObjectNode known;

    /** {@code customizers}: those of the description of REST, whose schemas are made in the same way. */
    public StreamDescription(StreamFace face, List<OpenApiCustomizer> customizers, JsonCodec json, String version) {
        this.topics = face.topics();
        this.said = face.messages();
        this.requests = face.requests();
        this.customizers = customizers;
        this.json = json.mapper();
        this.version = version;
    }

    /** As JSON; {@code protocol}: {@code ws} or {@code wss}, {@code host}: with the port. */
    public String at(String protocol, String host) {
        ObjectNode all = description().deepCopy();
        ((ObjectNode) all.path("servers").path("stream"))
                .put("protocol", protocol)
                .put("host", host);
        return json.writeValueAsString(all);
    }

    private ObjectNode description() {
        ObjectNode made = known;
        if (made == null) {
            made = make();
            known = made;
        }
        return made;
    }

    private ObjectNode make() {
        ObjectNode all = json.createObjectNode().put("asyncapi", "3.0.0");
        all.putObject("info")
                .put("title", "Dronemap, the stream")
                .put("version", version)
                .put(
                        "description",
                        "Says what changes, and takes commands. Angles in degrees, distances in metres, speeds in m/s, times in"
                                + " UTC; a fact that nobody knows is null. Programs show an access key as Authorization: Bearer KEY"
                                + " or in the first message, browsers a ticket.")
                .putObject("license")
                .put("name", "Apache-2.0")
                .put("url", "https://www.apache.org/licenses/LICENSE-2.0");
        ArrayNode security = all.putObject("servers").putObject("stream").putArray("security");
        reference(security.addObject(), "#/components/securitySchemes/accessKey");
        reference(security.addObject(), "#/components/securitySchemes/ticket");
        all.put("defaultContentType", "application/json");
        channel(all.putObject("channels").putObject("stream"));
        operations(all.putObject("operations"));
        components(all.putObject("components"));
        return all;
    }

    private void channel(ObjectNode channel) {
        channel.put("address", StreamServer.PATH);
        ObjectNode messages = channel.putObject("messages");
        said.records().values().forEach(record -> reference(messages.putObject(name(record)), message(record)));
        requests.alternatives()
                .records()
                .values()
                .forEach(record -> reference(messages.putObject(name(record)), message(record)));
        ObjectNode query = channel.putObject("bindings")
                .putObject("ws")
                .put("method", "GET")
                .putObject("query");
        ObjectNode members = query.put("type", "object").putObject("properties");
        members.putObject("ticket").put("type", "string").put("description", "Serves once, for 30 s");
        members.putObject("rate")
                .put("type", "integer")
                .put("minimum", 1)
                .put("maximum", PublishSchedule.MOST_PER_SECOND)
                .put("description", "Of each drone at most so many states a second");
    }

    private void operations(ObjectNode operations) {
        Set<Class<?>> told = new HashSet<>();
        topics.forEach(topic -> {
            List<Class<?>> messages = List.copyOf(topic.messages());
            told.addAll(messages);
            ObjectNode operation = operation(operations.putObject("tell" + word(topic.message())), "send", messages);
            operation.put(
                    "summary",
                    "Told: " + topic.rate().words() + ". To: "
                            + topic.audience().words() + ".");
        });
        requests.types().forEach((word, type) -> {
            ObjectNode operation = operation(operations.putObject(word), "receive", List.of(type.request()));
            operation.put("summary", type.access().words());
            ObjectNode reply = operation.putObject("reply");
            reference(reply.putObject("channel"), CHANNEL);
            ArrayNode answers = reply.putArray("messages");
            type.answer().ifPresent(answer -> {
                told.add(answer);
                reference(answers.addObject(), CHANNEL + "/messages/" + name(answer));
            });
            reference(answers.addObject(), CHANNEL + "/messages/" + name(StreamMessage.Failure.class));
        });
        List<Class<?>> others = said.records().values().stream()
                .filter(record -> !told.contains(record))
                .toList();
        operation(operations.putObject("tellOfConnection"), "send", others)
                .put("summary", "Told of the connection itself.");
    }

    private static ObjectNode operation(ObjectNode operation, String action, List<Class<?>> messages) {
        operation.put("action", action);
        reference(operation.putObject("channel"), CHANNEL);
        ArrayNode all = operation.putArray("messages");
        messages.forEach(record -> reference(all.addObject(), CHANNEL + "/messages/" + name(record)));
        return operation;
    }

    private void components(ObjectNode components) {
        ObjectNode messages = components.putObject("messages");
        said.records().forEach((type, record) -> message(messages, type, record));
        requests.alternatives().records().forEach((type, record) -> message(messages, type, record));
        components.set("schemas", StreamSchemas.of(said, requests, customizers, json));
        ObjectNode schemes = components.putObject("securitySchemes");
        schemes.putObject("accessKey").put("type", "http").put("scheme", "bearer");
        schemes.putObject("ticket")
                .put("type", "httpApiKey")
                .put("name", "ticket")
                .put("in", "query");
    }

    private static void message(ObjectNode messages, String type, Class<?> record) {
        ObjectNode message = messages.putObject(name(record));
        message.put("name", type).put("summary", schema(record).description());
        reference(message.putObject("payload"), "#/components/schemas/" + name(record));
    }

    private static String word(Class<?> record) {
        return name(record).substring("Stream".length());
    }

    private static String message(Class<?> record) {
        return "#/components/messages/" + name(record);
    }

    private static String name(Class<?> record) {
        return schema(record).name();
    }

    private static Schema schema(Class<?> record) {
        return Objects.requireNonNull(record.getAnnotation(Schema.class));
    }

    private static void reference(ObjectNode node, String to) {
        node.put("$ref", to);
    }
}
