package org.dronemap.ws.openapi;

import com.fasterxml.jackson.databind.JavaType;
import io.swagger.v3.core.converter.AnnotatedType;
import io.swagger.v3.core.converter.ModelConverter;
import io.swagger.v3.core.converter.ModelConverterContext;
import io.swagger.v3.core.util.Json;
import io.swagger.v3.oas.models.media.Schema;
import java.util.Iterator;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;

/**
 * Knows which Java record each schema of the OpenAPI description was made from. A name is said at the record itself, so
 * that renaming a class changes nothing that clients see; two records of one name would be one schema, and are refused.
 * Thread-safe.
 */
public final class RecordSchemaRegistry implements ModelConverter {
    private final Map<String, Class<?>> records = new ConcurrentHashMap<>();

    @Override
    public @Nullable Schema<?> resolve(
            AnnotatedType type, ModelConverterContext context, Iterator<ModelConverter> chain) {
        JavaType java = Json.mapper().constructType(type.getType());
        if (java != null && java.getRawClass().isRecord()) {
            register(java.getRawClass());
        }
        return chain.hasNext() ? chain.next().resolve(type, context, chain) : null;
    }

    private void register(Class<?> record) {
        String name = nameOf(record)
                .orElseThrow(() -> new IllegalStateException(
                        record.getName() + " has no name for clients: say @Schema(name = ...) there."));
        Class<?> other = records.putIfAbsent(name, record);
        if (other != null && other != record) {
            throw new IllegalStateException(
                    other.getName() + " and " + record.getName() + " have the same name for clients: " + name + ".");
        }
    }

    private static Optional<String> nameOf(Class<?> record) {
        return Optional.ofNullable(record.getAnnotation(io.swagger.v3.oas.annotations.media.Schema.class))
                .map(io.swagger.v3.oas.annotations.media.Schema::name)
                .filter(name -> !name.isEmpty());
    }

    Optional<Class<?>> of(String schema) {
        return Optional.ofNullable(records.get(schema));
    }
}
