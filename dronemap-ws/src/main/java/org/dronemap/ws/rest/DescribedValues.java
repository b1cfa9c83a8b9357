package org.dronemap.ws.rest;

import io.swagger.v3.oas.models.media.Schema;
import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.dronemap.ws.service.ValuesOf;
import org.dronemap.ws.service.WireNames;

/** Says in the description which values a text may have. */
final class DescribedValues {
    private DescribedValues() {}

    @SuppressWarnings({"rawtypes", "unchecked"})
    static void say(RecordComponent component, Schema<?> member) {
        ValuesOf values = component.getAnnotation(ValuesOf.class);
        if (values != null) {
            Schema text = Optional.<Schema>ofNullable(member.getItems()).orElse(member);
            text.setEnum(of(values));
        }
    }

    private static List<String> of(ValuesOf values) {
        return Stream.concat(
                        Arrays.stream(values.value().getEnumConstants()).map(WireNames::camel),
                        Arrays.stream(values.and()))
                .toList();
    }
}
