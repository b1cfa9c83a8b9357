package org.dronemap.ws.stream;

import com.fasterxml.jackson.annotation.JsonTypeName;
import io.swagger.v3.oas.annotations.media.Schema;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronemap.ws.environment.SetupException;
import org.dronemap.ws.reading.RecordAlternatives;
import org.springframework.core.Ordered;
import org.springframework.core.annotation.OrderUtils;

/** All types of messages that the server sends on the WebSocket stream, by name, as they are described. Immutable. */
public record StreamMessageCatalogue(Map<String, Class<?>> records) {
    private static final String NAME = "Stream";
    /** Of what says nothing: after what features say, before what the stream says of itself. */
    private static final int UNORDERED = Ordered.LOWEST_PRECEDENCE - 1;

    /**
     * The start fails where topics could not be told from each other; {@code others}: messages of features that belong to no
     * topic.
     */
    static StreamMessageCatalogue of(List<StreamTopic<?>> topics, List<Class<? extends StreamMessage>> others) {
        Map<String, Class<?>> records = new LinkedHashMap<>(
                RecordAlternatives.of(StreamMessage.class).orElseThrow().records());
        addTopics(records, topics);
        for (Class<? extends StreamMessage> message : others) {
            String type = typeOf(message);
            Class<?> other = records.putIfAbsent(type, message);
            if (other != null && other != message) {
                throw new SetupException("Two messages of the stream are of the type " + type + ": " + other.getName()
                        + " and " + message.getName() + "; each message needs a type of its own.");
            }
        }
        checkKinds(topics);
        return new StreamMessageCatalogue(inOrder(records));
    }

    private static Map<String, Class<?>> inOrder(Map<String, Class<?>> records) {
        Map<String, Class<?>> ordered = new LinkedHashMap<>();
        records.entrySet().stream()
                .sorted(Comparator.comparingInt(record -> OrderUtils.getOrder(record.getValue(), UNORDERED)))
                .forEach(record -> ordered.put(record.getKey(), record.getValue()));
        return ordered;
    }

    private static void addTopics(Map<String, Class<?>> records, List<StreamTopic<?>> topics) {
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
