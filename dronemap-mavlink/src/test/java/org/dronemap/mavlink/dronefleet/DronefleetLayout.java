package org.dronemap.mavlink.dronefleet;

import io.dronefleet.mavlink.annotations.MavlinkFieldInfo;
import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/** Where the fields of a message stand in its payload, by what dronefleet says of them. */
final class DronefleetLayout {
    private DronefleetLayout() {}

    /** One field in wire order. */
    record Field(String name, int offset, int unitSize, int count, boolean text) {
        int length() {
            return unitSize * count;
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
                    getter.getName(), offset, info.unitSize(), count, getter.getReturnType() == String.class));
            offset += info.unitSize() * count;
        }
        return fields;
    }

    static int length(Class<?> message) {
        return wireOrder(message).stream().mapToInt(Field::length).sum();
    }

    static int lengthWithoutExtensions(Class<?> message) {
        return Arrays.stream(message.getMethods())
                .filter(method -> method.isAnnotationPresent(MavlinkFieldInfo.class))
                .map(DronefleetLayout::info)
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

    private static MavlinkFieldInfo info(Method method) {
        return method.getAnnotation(MavlinkFieldInfo.class);
    }
}
