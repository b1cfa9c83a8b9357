package org.dronemap.proxy.mavlink.translate;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.reflect.Constructor;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dronemap.mavlink.Message;

/** A message as the definitions have it, from which any of its values can be made. */
record DefinedMessage(String name, List<Field> fields) {
    private static final Path DEFINITIONS = Path.of("../dronemap-mavlink/src/main/mavlink/definitions.txt");

    /** A number of the wire; {@code count} is 1 for what is no array. */
    record Field(String name, String type, int count) {
        boolean isText() {
            return type.equals("char");
        }

        /** All that this field could be which is no usual value: what marks it as unknown, and the limits of its type. */
        List<Number> extremes() {
            return switch (type) {
                case "uint8_t" -> List.of(255, 0, 254);
                case "int8_t" -> List.of(127, -128, -1, 0);
                case "uint16_t" -> List.of(65_535, 0, 65_534);
                case "int16_t" -> List.of(32_767, -32_768, -1, 0);
                case "uint32_t" -> List.of(4_294_967_295L, 0L);
                case "int32_t" -> List.of(Integer.MAX_VALUE, Integer.MIN_VALUE, -1, 0);
                case "uint64_t", "int64_t" -> List.of(-1L, Long.MAX_VALUE, Long.MIN_VALUE, 0L);
                case "float" ->
                    List.of(
                            Float.NaN,
                            Float.POSITIVE_INFINITY,
                            Float.NEGATIVE_INFINITY,
                            Float.MAX_VALUE,
                            -Float.MAX_VALUE,
                            -1f,
                            0f);
                case "char" -> List.of(0);
                default -> throw new AssertionError(type);
            };
        }

        private Object value(Number number, Class<?> wanted) {
            if (isText()) {
                return number.intValue() == 0 ? "" : "A";
            }
            if (wanted.isArray()) {
                Object array = java.lang.reflect.Array.newInstance(wanted.getComponentType(), count);
                for (int i = 0; i < count; i++) {
                    java.lang.reflect.Array.set(array, i, cast(number, wanted.getComponentType()));
                }
                return array;
            }
            return cast(number, wanted);
        }

        private static Object cast(Number number, Class<?> wanted) {
            return wanted == float.class
                    ? (Object) number.floatValue()
                    : wanted == double.class
                            ? (Object) number.doubleValue()
                            : wanted == long.class ? (Object) number.longValue() : (Object) number.intValue();
        }
    }

    static List<DefinedMessage> all() {
        List<DefinedMessage> all = new ArrayList<>();
        try {
            for (String line : Files.readAllLines(DEFINITIONS)) {
                String[] words = line.strip().split("\\s+");
                if (line.matches("\\d+ [A-Z].*")) {
                    all.add(new DefinedMessage(words[1], new ArrayList<>()));
                } else if (line.startsWith(" ") && words.length == 2) {
                    String[] type = words[0].split("[\\[\\]]");
                    all.get(all.size() - 1)
                            .fields()
                            .add(new Field(words[1], type[0], type.length > 1 ? Integer.parseInt(type[1]) : 1));
                }
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return all;
    }

    /** The record's name. */
    String recordName() {
        StringBuilder camel = new StringBuilder();
        for (String word : name.split("_")) {
            camel.append(word.charAt(0)).append(word.substring(1).toLowerCase(Locale.ROOT));
        }
        return camel.toString();
    }

    /** All fields have the one value, but this one has that. */
    Message with(Number usual, Field odd, Number extreme) {
        try {
            Constructor<?> made = Class.forName("org.dronemap.mavlink.message." + recordName())
                    .getConstructors()[0];
            Object[] values = new Object[fields.size()];
            for (int i = 0; i < values.length; i++) {
                Field field = fields.get(i);
                values[i] = field.value(field.equals(odd) ? extreme : usual, made.getParameterTypes()[i]);
            }
            return (Message) made.newInstance(values);
        } catch (ReflectiveOperationException e) {
            throw new AssertionError(name, e);
        }
    }

    /** All fields have that value. */
    Message of(Number usual) {
        return with(usual, new Field("", "", 0), 0);
    }
}
