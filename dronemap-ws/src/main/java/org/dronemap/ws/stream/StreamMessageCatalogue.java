package org.dronemap.ws.stream;

import com.fasterxml.jackson.annotation.JsonTypeName;
import io.swagger.v3.oas.annotations.media.Schema;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronemap.ws.environment.SetupException;
import org.dronemap.ws.reading.RecordAlternatives;

/** All types of messages that the server sends on the WebSocket stream, by name. Immutable. */
public record StreamMessageCatalogue(Map<String, Class<?>> records) {
    private static final String NAME = "Stream";

    /** The start fails where topics could not be told from each other. */
    static StreamMessageCatalogue of(List<StreamTopic<?>> topics) {
        Map<String, Class<?>> records = new LinkedHashMap<>(
                RecordAlternatives.of(StreamMessage.class).orElseThrow().records());
        Set<Class<?>> told = new HashSet<>();
        for (StreamTopic<?> topic : topics) {
            for (Class<? extends StreamMessage> message : topic.messages()) {
                String type = typeOf(message);
                Class<?> other = records.putIfAbsent(type, message);
                boolean isTaken = other != null && other != message;
                if (isTaken || !told.add(message)) {
                    throw new SetupException("Two topics of the stream tell messages of the type " + type + ": "
                            + (other == null ? message : other).getName() + " and " + message.getName()
                            + "; each message needs a type of its own.");
                }
            }
        }
        checkKinds(topics);
        return new StreamMessageCatalogue(records);
    }

    /** Those that are not among the messages of {@link StreamMessage} itself. */
    public Map<String, Class<?>> ofUseCases() {
        Map<String, Class<?>> own = new LinkedHashMap<>(records);
        own.values().removeIf(record -> !StreamMessage.OfUseCase.class.isAssignableFrom(record));
        return own;
    }

    private static String typeOf(Class<? extends StreamMessage> message) {
        boolean ofUseCase = StreamMessage.OfUseCase.class.isAssignableFrom(message);
        JsonTypeName type = message.getDeclaredAnnotation(JsonTypeName.class);
        if (ofUseCase && (type == null || type.value().isEmpty())) {
            throw new SetupException(message.getName() + " has no type for clients: say @JsonTypeName(...) there.");
        }
        Schema said = message.getDeclaredAnnotation(Schema.class);
        if (said == null
                || !said.name().matches(NAME + "\\w+")
                || said.description().isEmpty()) {
            throw new SetupException(message.getName()
                    + " has no name for clients that begins with Stream, or no description: say @Schema(name = ...,"
                    + " description = ...) there.");
        }
        return type == null || !ofUseCase
                ? RecordAlternatives.with(message).orElseThrow().nameOf(message)
                : type.value();
    }

    /** A newer picture would replace one of another topic, and one removal would be told for both. */
    private static void checkKinds(List<StreamTopic<?>> topics) {
        Map<String, StreamTopic<?>> known = new HashMap<>();
        for (StreamTopic<?> topic : topics) {
            boolean keepsPictures = !(topic.rate() instanceof StreamTopicRate.EveryChange) || topic.isWithdrawn();
            StreamTopic<?> other =
                    keepsPictures ? known.putIfAbsent(topic.about().kind(), topic) : null;
            if (other != null) {
                throw new SetupException("Two topics of the stream are about things of the kind "
                        + topic.about().kind() + ": those of " + other.message().getName() + " and of "
                        + topic.message().getName() + "; each topic needs a kind of its own.");
            }
        }
    }
}
