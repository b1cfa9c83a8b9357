package org.dronemap.ws.journal;

import java.lang.reflect.Type;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import org.dronemap.core.operation.Computation;
import org.dronemap.core.operation.OperationAction;
import org.dronemap.core.operation.OperationCodec;
import org.dronemap.core.operation.OperationDecision;
import tools.jackson.core.JacksonException;
import tools.jackson.core.StreamReadFeature;
import tools.jackson.databind.DeserializationFeature;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * Reads and writes an operation's states, inputs and decisions as JSON lines; a decision holds a state's SHA-256 only.
 * Any thread.
 */
class JsonOperationCodec<S, I> implements OperationCodec<S, I> {
    private final JsonMapper mapper = JsonMapper.builder()
            .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
            .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
            .build();
    private final Class<S> state;
    private final Class<I> input;
    private final ValueCodecRegistry forms;

    /** {@code computations}: those that operations of this kind ask for. */
    protected JsonOperationCodec(Class<S> state, Class<I> input, List<Class<?>> computations) {
        this.state = state;
        this.input = input;
        this.forms = new ValueCodecRegistry(Map.of(Computation.class, computations));
        forms.requireNames(state, input, OperationAction.class);
    }

    @Override
    public final String state(S value) {
        return write(state, value);
    }

    @Override
    public final S state(String text) {
        return state.cast(read(state, text));
    }

    @Override
    public String input(I value) {
        return write(input, value);
    }

    @Override
    public I input(String text) {
        return input.cast(read(input, text));
    }

    @Override
    public final String decision(OperationDecision<S, I> decision) {
        ObjectNode node = mapper.createObjectNode();
        ArrayNode actions = node.putArray("actions");
        decision.actions()
                .forEach(action -> actions.add(forms.of(OperationAction.class).write(action)));
        node.put("why", decision.why());
        node.put("next", hash(state(decision.next())));
        return text(node);
    }

    String write(Type type, Object value) {
        return text(forms.of(type).write(value));
    }

    Object read(Type type, String text) {
        JsonNode node;
        try {
            node = mapper.readTree(text);
        } catch (JacksonException e) {
            throw new IllegalArgumentException("not JSON: " + e.getOriginalMessage(), e);
        }
        return forms.of(type).read(node);
    }

    private String text(JsonNode node) {
        return mapper.writeValueAsString(node);
    }

    private static String hash(String text) {
        try {
            byte[] digest = MessageDigest.getInstance("SHA-256").digest(text.getBytes(StandardCharsets.UTF_8));
            return HexFormat.of().formatHex(digest);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }
}
