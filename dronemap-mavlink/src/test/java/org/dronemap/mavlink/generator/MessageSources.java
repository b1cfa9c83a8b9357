package org.dronemap.mavlink.generator;

import io.dronefleet.mavlink.annotations.MavlinkFieldInfo;
import io.dronefleet.mavlink.annotations.MavlinkMessageInfo;
import java.lang.reflect.Method;
import java.lang.reflect.ParameterizedType;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;

/** Writes the Java record of one MAVLink message from the definition that dronefleet carries. */
final class MessageSources {
    private MessageSources() {}

    /** One field in wire order. */
    record Field(String name, int offset, int unitSize, int count, boolean signed, String javaType, int position) {
        boolean array() {
            return count > 1 && !javaType.equals("String");
        }
    }

    static List<Field> wireOrder(Class<?> message) {
        List<Method> getters = Arrays.stream(message.getMethods())
                .filter(method -> method.isAnnotationPresent(MavlinkFieldInfo.class))
                .sorted(Comparator.comparing((Method method) -> info(method).extension())
                        .thenComparing(method ->
                                info(method).extension() ? 0 : -info(method).unitSize())
                        .thenComparing(method -> info(method).position()))
                .toList();
        List<Field> fields = new ArrayList<>();
        int offset = 0;
        for (Method getter : getters) {
            MavlinkFieldInfo info = info(getter);
            int count = Math.max(1, info.arraySize());
            fields.add(new Field(
                    getter.getName(),
                    offset,
                    info.unitSize(),
                    count,
                    info.signed(),
                    javaType(getter),
                    info.position()));
            offset += info.unitSize() * count;
        }
        return fields;
    }

    static int length(Class<?> message) {
        return wireOrder(message).stream()
                .mapToInt(field -> field.unitSize() * field.count())
                .sum();
    }

    static int lengthWithoutExtensions(Class<?> message) {
        return Arrays.stream(message.getMethods())
                .filter(method -> method.isAnnotationPresent(MavlinkFieldInfo.class))
                .map(MessageSources::info)
                .filter(info -> !info.extension())
                .mapToInt(info -> info.unitSize() * Math.max(1, info.arraySize()))
                .sum();
    }

    /** Where the payload says whom it is for; -1: it does not. */
    static int targetSystemOffset(Class<?> message) {
        return wireOrder(message).stream()
                .filter(field -> field.name().equals("targetSystem"))
                .mapToInt(Field::offset)
                .findFirst()
                .orElse(-1);
    }

    static String source(Class<?> message) {
        MavlinkMessageInfo info = message.getAnnotation(MavlinkMessageInfo.class);
        List<Field> wire = wireOrder(message);
        List<Field> declared =
                wire.stream().sorted(Comparator.comparing(Field::position)).toList();
        boolean arrays = wire.stream().anyMatch(Field::array);
        String name = message.getSimpleName();
        String components = declared.stream()
                .map(field -> field.javaType() + (field.array() ? "[] " : " ") + field.name())
                .collect(Collectors.joining(", "));
        String reads = declared.stream().map(MessageSources::read).collect(Collectors.joining(", "));
        String writes = wire.stream().map(MessageSources::write).collect(Collectors.joining("\n"));
        return "package org.dronemap.mavlink.message;\n\n"
                + "import org.dronemap.mavlink.Frame;\nimport org.dronemap.mavlink.Message;\n"
                + "import org.dronemap.mavlink.PayloadWriter;\n\n"
                + "/** MAVLink message " + info.id()
                + ", raw fields as on the wire. Generated: see MessageGenerator. */\n"
                + (arrays ? "@SuppressWarnings(\"ArrayRecordComponent\")\n" : "")
                + "public record " + name + "(" + components + ") implements Message {\n"
                + "public static final int ID = " + info.id() + ";\n\n"
                + "public static " + name + " decode(Frame frame) {\nreturn new " + name + "(" + reads + ");\n}\n\n"
                + "@Override\npublic int messageId() {\nreturn ID;\n}\n\n"
                + "@Override\npublic void write(PayloadWriter out) {\n" + writes + "\n}\n}\n";
    }

    private static String read(Field field) {
        if (field.javaType().equals("String")) {
            return "frame.text(" + field.offset() + ", " + field.count() + ")";
        }
        return "frame." + accessor(field) + (field.array() ? "s(" : "(") + field.offset()
                + (field.array() ? ", " + field.count() : "") + ")";
    }

    private static String write(Field field) {
        if (field.javaType().equals("String")) {
            return "out.text(" + field.name() + ", " + field.count() + ");";
        }
        return "out." + accessor(field) + (field.array() ? "s(" : "(") + field.name()
                + (field.array() ? ", " + field.count() : "") + ");";
    }

    private static String accessor(Field field) {
        return switch (field.javaType()) {
            case "float" -> "f32";
            case "double" -> "f64";
            default -> (field.signed() || field.unitSize() == 8 ? "i" : "u") + field.unitSize() * 8;
        };
    }

    private static String javaType(Method getter) {
        MavlinkFieldInfo info = info(getter);
        Class<?> type = getter.getReturnType();
        if (type == String.class) {
            return "String";
        }
        if (type == List.class) {
            Class<?> element =
                    (Class<?>) ((ParameterizedType) getter.getGenericReturnType()).getActualTypeArguments()[0];
            type = element;
        }
        if (type == float.class || type == Float.class) {
            return "float";
        }
        if (type == double.class || type == Double.class) {
            return "double";
        }
        return info.unitSize() == 8 || (info.unitSize() == 4 && !info.signed()) ? "long" : "int";
    }

    private static MavlinkFieldInfo info(Method method) {
        return method.getAnnotation(MavlinkFieldInfo.class);
    }
}
