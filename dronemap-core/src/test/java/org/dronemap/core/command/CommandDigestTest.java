package org.dronemap.core.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Constructor;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.IntFunction;
import java.util.stream.Stream;
import org.dronemap.core.mission.MissionItem;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Walks all commands that there are, and all components of what they are made of. */
class CommandDigestTest {
    private static final Map<Class<?>, IntFunction<Object>> SIMPLE = Map.of(
            double.class, variant -> 2.0 + variant,
            Double.class, variant -> 2.0 + variant,
            int.class, variant -> 3 + variant,
            long.class, variant -> 4L + variant,
            boolean.class, variant -> variant == 1,
            String.class, variant -> "TEXT" + variant,
            Instant.class, Instant.EPOCH::plusSeconds);

    static Stream<Class<?>> commands() {
        return cases(Command.class);
    }

    /** All records under a sealed interface. */
    private static Stream<Class<?>> cases(Class<?> type) {
        return type.isSealed()
                ? Arrays.stream(type.getPermittedSubclasses()).flatMap(CommandDigestTest::cases)
                : Stream.of(type);
    }

    @ParameterizedTest
    @MethodSource("commands")
    void oneChangedComponentIsAnotherCommand(Class<?> type) throws ReflectiveOperationException {
        Command command = (Command) values(type, 0).get(0);
        assertThat(CommandDigest.of("ann", command))
                .isEqualTo(CommandDigest.of("ann", (Command) values(type, 0).get(0)));
        List<Object> others = changed((Record) command);
        assertThat(others)
                .allSatisfy(other -> assertThat(CommandDigest.of("ann", (Command) other))
                        .as("%s and %s", command, other)
                        .isNotEqualTo(CommandDigest.of("ann", command)));
    }

    @ParameterizedTest
    @MethodSource("commands")
    void eachTypeIsAnotherOne(Class<?> type) throws ReflectiveOperationException {
        String digest = CommandDigest.of("ann", (Command) values(type, 0).get(0));
        for (Class<?> other : commands().filter(one -> one != type).toList()) {
            assertThat(CommandDigest.of("ann", (Command) values(other, 0).get(0)))
                    .isNotEqualTo(digest);
        }
    }

    /** The record with one component changed each time, those of what stands in it as well. */
    private static List<Object> changed(Record original) throws ReflectiveOperationException {
        List<Object> changed = new ArrayList<>();
        RecordComponent[] components = original.getClass().getRecordComponents();
        for (int index = 0; index < components.length; index++) {
            if (isPort(components[index].getType())) {
                continue;
            }
            Object before = components[index].getAccessor().invoke(original);
            for (Object after : others(components[index].getGenericType(), before)) {
                Object[] all = new Object[components.length];
                for (int i = 0; i < all.length; i++) {
                    all[i] = i == index ? after : components[i].getAccessor().invoke(original);
                }
                changed.add(make(original.getClass(), all));
            }
        }
        return changed;
    }

    /** Nothing that is asked, but where something goes. */
    private static boolean isPort(Class<?> type) {
        return type == VehicleLogSink.class || type == ParameterOverrideRecorder.class;
    }

    private static List<Object> others(Type type, Object before) throws ReflectiveOperationException {
        List<Object> others = new ArrayList<>();
        if (before instanceof List<?> list) {
            List<?> longer = values(((ParameterizedType) type).getActualTypeArguments()[0], 1);
            List<Object> one = new ArrayList<>(list);
            one.add(longer.get(0));
            others.add(List.copyOf(one));
            for (Object each : longer) {
                List<Object> replaced = new ArrayList<>(list);
                replaced.set(0, each);
                others.add(List.copyOf(replaced));
            }
            for (Object each : others(((ParameterizedType) type).getActualTypeArguments()[0], list.get(0))) {
                List<Object> replaced = new ArrayList<>(list);
                replaced.set(0, each);
                others.add(List.copyOf(replaced));
            }
        } else {
            if (before instanceof Record part) {
                others.addAll(changed(part));
            }
            others.addAll(values(type, 1));
        }
        others.removeIf(other -> other.equals(before));
        return others;
    }

    /** One value of each case of a type; {@code variant}: others than those of another variant. */
    private static List<Object> values(Type type, int variant) throws ReflectiveOperationException {
        if (type instanceof ParameterizedType list) {
            Object one = values(list.getActualTypeArguments()[0], variant).get(0);
            return List.of(List.of(one, one, one));
        }
        Class<?> raw = (Class<?>) type;
        if (raw.isEnum()) {
            return List.of(raw.getEnumConstants()[variant]);
        } else if (isPort(raw)) {
            return Arrays.asList((Object) null);
        } else if (SIMPLE.containsKey(raw)) {
            return List.of(SIMPLE.get(raw).apply(variant));
        }
        List<Object> made = new ArrayList<>();
        for (Class<?> each : cases(raw).toList()) {
            RecordComponent[] components = each.getRecordComponents();
            Object[] all = new Object[components.length];
            for (int i = 0; i < all.length; i++) {
                all[i] = values(components[i].getGenericType(), variant).get(0);
            }
            if (each != MissionItem.Other.class) {
                made.add(make(each, all));
            }
        }
        return made;
    }

    private static Object make(Class<?> type, Object[] values) throws ReflectiveOperationException {
        Class<?>[] types = Arrays.stream(type.getRecordComponents())
                .map(RecordComponent::getType)
                .toArray(Class<?>[]::new);
        Constructor<?> constructor = type.getDeclaredConstructor(types);
        return constructor.newInstance(values);
    }
}
