package org.dronemap.ws.openapi;

import io.swagger.v3.oas.models.media.Schema;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.WireNames;

/** Adds allowed values (enum) and value types of a record component to its schema in the OpenAPI description. */
final class AllowedValuesSchema {
    private AllowedValuesSchema() {}

    @SuppressWarnings({"rawtypes", "unchecked"})
    static void describe(RecordComponent component, Schema<?> member) {
        EnumValues values = component.getAnnotation(EnumValues.class);
        if (values != null) {
            Schema text = Optional.<Schema>ofNullable(member.getItems()).orElse(member);
            text.setEnum(of(values));
        }
        if (isOfPlainValues(component)) {
            member.setAdditionalProperties(plain());
        }
    }

    /** Texts, numbers or truths, which the type of a map does not say. */
    static Schema<?> plain() {
        return new Schema<>().oneOf(List.of(type("string"), type("number"), type("boolean")));
    }

    private static boolean isOfPlainValues(RecordComponent component) {
        return component.getGenericType() instanceof ParameterizedType map
                && map.getRawType().equals(Map.class)
                && map.getActualTypeArguments()[1].equals(Object.class);
    }

    private static Schema<?> type(String name) {
        return new Schema<>().types(Set.of(name));
    }

    private static List<String> of(EnumValues values) {
        return Stream.concat(
                        Arrays.stream(values.value().getEnumConstants()).map(WireNames::camel),
                        Arrays.stream(values.and()))
                .toList();
    }
}
