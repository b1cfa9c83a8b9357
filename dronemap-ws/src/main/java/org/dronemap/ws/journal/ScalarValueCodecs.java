package org.dronemap.ws.journal;

import java.time.Duration;
import java.time.Instant;
import java.time.format.DateTimeParseException;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import org.dronemap.core.stored.StoredNames;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.JsonNodeFactory;

/** Journal codecs of numbers, texts, times and other single values; numbers that JSON lacks are written as words. */
final class ScalarValueCodecs {
    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

    private static final ValueCodec WHOLE = form(
            value -> NODES.numberNode(((Number) value).intValue()),
            node -> node.isIntegralNumber() && node.canConvertToInt(),
            JsonNode::intValue);
    private static final ValueCodec LONG = form(
            value -> NODES.numberNode(((Number) value).longValue()),
            node -> node.isIntegralNumber() && node.canConvertToLong(),
            JsonNode::longValue);
    private static final ValueCodec DOUBLE =
            form(ScalarValueCodecs::number, ScalarValueCodecs::isNumber, ScalarValueCodecs::number);
    private static final ValueCodec TRUTH =
            form(value -> NODES.booleanNode((Boolean) value), JsonNode::isBoolean, JsonNode::booleanValue);
    private static final ValueCodec TEXT =
            form(value -> NODES.stringNode((String) value), JsonNode::isString, JsonNode::stringValue);

    private static final Map<Class<?>, ValueCodec> ALL = Map.ofEntries(
            Map.entry(int.class, WHOLE),
            Map.entry(Integer.class, WHOLE),
            Map.entry(long.class, LONG),
            Map.entry(Long.class, LONG),
            Map.entry(double.class, DOUBLE),
            Map.entry(Double.class, DOUBLE),
            Map.entry(boolean.class, TRUTH),
            Map.entry(Boolean.class, TRUTH),
            Map.entry(String.class, TEXT),
            Map.entry(Instant.class, spelt(Instant::parse)),
            Map.entry(Duration.class, spelt(Duration::parse)));

    private ScalarValueCodecs() {}

    static Optional<ValueCodec> of(Class<?> type) {
        return type.isEnum() ? Optional.of(enumeration(type)) : Optional.ofNullable(ALL.get(type));
    }

    @SuppressWarnings({"unchecked", "rawtypes"})
    private static ValueCodec enumeration(Class type) {
        return spelt(text -> StoredNames.constant(type, text), value -> StoredNames.of((Enum<?>) value));
    }

    private static ValueCodec spelt(Function<String, Object> parse) {
        return spelt(parse, Object::toString);
    }

    /** Only in the one way in which it is written. */
    private static ValueCodec spelt(Function<String, Object> parse, Function<Object, String> write) {
        return form(value -> NODES.stringNode(write.apply(value)), JsonNode::isString, node -> {
            String text = node.stringValue();
            Object value;
            try {
                value = parse.apply(text);
            } catch (DateTimeParseException e) {
                throw new IllegalArgumentException("not a time: " + text, e);
            }
            if (!write.apply(value).equals(text)) {
                throw new IllegalArgumentException("not as it is written: " + text);
            }
            return value;
        });
    }

    private static JsonNode number(Object value) {
        double number = (Double) value;
        return Double.isFinite(number) ? NODES.numberNode(number) : NODES.stringNode(Double.toString(number));
    }

    private static boolean isNumber(JsonNode node) {
        return node.isNumber() || (node.isString() && !Double.isFinite(infinite(node.stringValue())));
    }

    private static Object number(JsonNode node) {
        return node.isNumber() ? node.doubleValue() : infinite(node.stringValue());
    }

    private static double infinite(String text) {
        return switch (text) {
            case "Infinity" -> Double.POSITIVE_INFINITY;
            case "-Infinity" -> Double.NEGATIVE_INFINITY;
            case "NaN" -> Double.NaN;
            default -> 0;
        };
    }

    private static ValueCodec form(
            Function<Object, JsonNode> write, Predicate<JsonNode> fits, Function<JsonNode, Object> read) {
        return new ValueCodec() {
            @Override
            public JsonNode write(Object value) {
                return write.apply(value);
            }

            @Override
            public Object read(JsonNode node) {
                if (!fits.test(node)) {
                    throw new IllegalArgumentException("not of the type that belongs there: " + node);
                }
                return read.apply(node);
            }
        };
    }
}
