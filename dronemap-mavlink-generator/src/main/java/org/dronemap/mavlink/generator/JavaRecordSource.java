package org.dronemap.mavlink.generator;

import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;

/** Builds the Java source of the record of one MAVLink message. */
final class JavaRecordSource {
    private static final int WIDTH = 120;
    private static final String IMPLEMENTS = " implements Message {";
    private static final String HEAD = """
            package org.dronemap.mavlink.message;

            import org.dronemap.mavlink.Frame;
            import org.dronemap.mavlink.Message;
            import org.dronemap.mavlink.PayloadWriter;

            /** MAVLink message %d, raw fields as on the wire. Generated: see MessageGenerator. */
            """;
    private static final String BODY = """
                public static final int ID = %d;

                public static %s decode(Frame frame) {
            %s    }

                @Override
                public int messageId() {
                    return ID;
                }

                @Override
                public void write(PayloadWriter out) {
            %s    }
            }
            """;

    private JavaRecordSource() {}

    static String of(MessageDefinition message) {
        boolean arrays = message.fields().stream().anyMatch(MessageField::isArray);
        String writes = message.wireOrder().stream()
                .map(place -> "        " + write(place.field()) + "\n")
                .collect(Collectors.joining());
        return HEAD.formatted(message.id())
                + (arrays ? "@SuppressWarnings(\"ArrayRecordComponent\")\n" : "")
                + declaration(message)
                + BODY.formatted(message.id(), message.recordName(), creation(message), writes);
    }

    private static String declaration(MessageDefinition message) {
        List<String> components = message.fields().stream()
                .map(field -> field.javaType() + " " + field.javaName())
                .toList();
        List<String> lines = lines("", "public record " + message.recordName() + "(", components, ")");
        String last = lines.get(lines.size() - 1) + IMPLEMENTS;
        boolean beside = lines.size() <= 2 && last.length() <= WIDTH;
        return String.join("\n", lines) + (beside ? "" : "\n       ") + IMPLEMENTS + "\n";
    }

    private static String creation(MessageDefinition message) {
        Map<MessageField, Integer> offsets = message.wireOrder().stream()
                .collect(Collectors.toMap(MessageDefinition.Place::field, MessageDefinition.Place::offset));
        Function<MessageField, String> read = field -> read(field, offsets.getOrDefault(field, 0));
        List<String> reads = message.fields().stream().map(read).toList();
        return String.join("\n", lines("        ", "return new " + message.recordName() + "(", reads, ");")) + "\n";
    }

    /** All on one line; else all elements on a second one; else each on its own. */
    private static List<String> lines(String indent, String begin, List<String> elements, String end) {
        String all = String.join(", ", elements) + end;
        String further = indent + "        ";
        if (indent.length() + begin.length() + all.length() <= WIDTH) {
            return List.of(indent + begin + all);
        }
        if (further.length() + all.length() <= WIDTH) {
            return List.of(indent + begin, further + all);
        }
        String each = indent + begin + "\n" + further + String.join(",\n" + further, elements) + end;
        return each.lines().toList();
    }

    private static String read(MessageField field, int offset) {
        return "frame." + method(field) + "(" + offset + elements(field) + ")";
    }

    private static String write(MessageField field) {
        return "out." + method(field) + "(" + field.javaName() + elements(field) + ");";
    }

    private static String method(MessageField field) {
        return field.type().accessor() + (field.isArray() ? "s" : "");
    }

    private static String elements(MessageField field) {
        return field.elements() > 0 ? ", " + field.elements() : "";
    }
}
