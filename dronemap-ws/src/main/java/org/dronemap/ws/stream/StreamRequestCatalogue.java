package org.dronemap.ws.stream;

import com.fasterxml.jackson.annotation.JsonTypeName;
import io.swagger.v3.oas.annotations.media.Schema;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.AuditPolicy;
import org.dronemap.ws.access.RequestCost;
import org.dronemap.ws.environment.SetupException;
import org.dronemap.ws.reading.JsonCodec;
import org.dronemap.ws.reading.RecordAlternatives;
import tools.jackson.databind.jsontype.NamedType;

/** All types of requests that clients may send on the WebSocket stream, by name. Immutable. */
public final class StreamRequestCatalogue {
    private static final StreamRequestType<StreamRequest.Authenticate> AUTHENTICATE = new StreamRequestType<>(
            StreamRequest.Authenticate.class,
            new StreamAccessRule.StreamOnly<>(
                    AccessLevel.ANYBODY,
                    RequestCost.NOTHING,
                    AuditPolicy.REFUSALS_ONLY,
                    "REST is shown a key with each request, a stream once."),
            StreamMessage.Hello.class);
    private static final StreamRequestType<StreamRequest.Subscribe> SUBSCRIBE = new StreamRequestType<>(
            StreamRequest.Subscribe.class,
            new StreamAccessRule.StreamOnly<>(
                    AccessLevel.VIEWER,
                    RequestCost.REQUEST,
                    AuditPolicy.LEFT_OUT,
                    "It is about what this connection is told."),
            null);
    private static final StreamRequestType<StreamRequest.Ping> PING = new StreamRequestType<>(
            StreamRequest.Ping.class,
            new StreamAccessRule.StreamOnly<>(
                    AccessLevel.VIEWER,
                    RequestCost.REQUEST,
                    AuditPolicy.LEFT_OUT,
                    "It asks whether this connection stands."),
            StreamMessage.Pong.class);

    private final Map<String, StreamRequestType<?>> types;
    private final List<StreamOperation<?>> operations;

    private StreamRequestCatalogue(Map<String, StreamRequestType<?>> types, List<StreamOperation<?>> operations) {
        this.types = types;
        this.operations = operations;
    }

    /** {@code operations}: in the order in which they are named to clients. The start fails where two have one name. */
    static StreamRequestCatalogue of(List<StreamOperation<?>> operations) {
        Map<String, StreamRequestType<?>> types = new LinkedHashMap<>();
        add(types, AUTHENTICATE);
        operations.forEach(operation -> add(types, operation.type()));
        add(types, SUBSCRIBE);
        add(types, PING);
        return new StreamRequestCatalogue(types, List.copyOf(operations));
    }

    private static void add(Map<String, StreamRequestType<?>> types, StreamRequestType<?> type) {
        String name = nameOf(type.request());
        StreamRequestType<?> other = types.putIfAbsent(name, type);
        if (other != null) {
            throw new SetupException("Two requests of the stream are of the type " + name + ": "
                    + other.request().getName() + " and " + type.request().getName()
                    + "; each request needs a type of its own.");
        }
    }

    private static String nameOf(Class<? extends StreamRequest> request) {
        Schema described = request.getDeclaredAnnotation(Schema.class);
        if (described == null
                || !described.name().matches("Stream\\w+Request")
                || described.description().isEmpty()) {
            throw new SetupException(request.getName()
                    + " has no name for clients of the form Stream...Request, or no description: say"
                    + " @Schema(name = ..., description = ...) there.");
        }
        JsonTypeName own = request.getDeclaredAnnotation(JsonTypeName.class);
        return own != null
                ? own.value()
                : RecordAlternatives.with(request)
                        .filter(all -> all.records().containsValue(request))
                        .orElseThrow(() -> new SetupException(
                                request.getName() + " has no type for clients: say @JsonTypeName(...) there."))
                        .nameOf(request);
    }

    /** In the order in which they are named to clients. */
    public Map<String, StreamRequestType<?>> types() {
        return types;
    }

    /** The records, and the member that tells them apart. */
    public RecordAlternatives alternatives() {
        Map<String, Class<?>> records = new LinkedHashMap<>();
        types.forEach((name, type) -> records.put(name, type.request()));
        String member = RecordAlternatives.of(StreamRequest.class).orElseThrow().member();
        return new RecordAlternatives(member, records);
    }

    /** One that reads all of them. */
    JsonCodec reader(JsonCodec json) {
        NamedType[] declared = types.entrySet().stream()
                .map(type -> new NamedType(type.getValue().request(), type.getKey()))
                .toArray(NamedType[]::new);
        return new JsonCodec(json.mapper().rebuild().registerSubtypes(declared).build());
    }

    /** As clients call it. */
    String nameOf(StreamRequest request) {
        return entry(request).getKey();
    }

    StreamRequestType<?> typeOf(StreamRequest request) {
        return entry(request).getValue();
    }

    private Map.Entry<String, StreamRequestType<?>> entry(StreamRequest request) {
        return types.entrySet().stream()
                .filter(type -> type.getValue().request().isInstance(request))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(request.getClass() + " is of no type."));
    }

    /** Empty: the stream carries it out itself. */
    Optional<StreamOperation<?>> operation(StreamRequest request) {
        return operations.stream()
                .filter(operation -> operation.type().request().isInstance(request))
                .findFirst();
    }
}
