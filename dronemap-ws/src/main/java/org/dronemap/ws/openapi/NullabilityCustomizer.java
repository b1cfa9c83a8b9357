package org.dronemap.ws.openapi;

import com.fasterxml.jackson.annotation.JsonInclude;
import io.swagger.v3.oas.models.OpenAPI;
import io.swagger.v3.oas.models.Operation;
import io.swagger.v3.oas.models.media.Content;
import io.swagger.v3.oas.models.media.Schema;
import java.lang.reflect.AnnotatedParameterizedType;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.springdoc.core.customizers.OpenApiCustomizer;

/** Adds to the OpenAPI description types, nullability and required members of all schemas. */
public final class NullabilityCustomizer implements OpenApiCustomizer {
    private static final String REFERENCE = "#/components/schemas/";
    private static final String NULL = "null";

    private final RecordSchemaRegistry records;

    public NullabilityCustomizer(RecordSchemaRegistry records) {
        this.records = records;
    }

    @Override
    @SuppressWarnings({"rawtypes", "unchecked"})
    public void customise(OpenAPI description) {
        Map<String, Schema> schemas = description.getComponents().getSchemas();
        Set<String> sent = sent(description);
        schemas.forEach((name, schema) -> records.of(name).ifPresent(record -> {
            // What is null in these is left out.
            boolean partly = record.isAnnotationPresent(JsonInclude.class);
            boolean whole = !sent.contains(name) && !partly;
            boolean nulls = whole || sent.contains(name);
            for (RecordComponent component : record.getRecordComponents()) {
                Schema<?> member = schema.getProperties() == null
                        ? null
                        : (Schema<?>) schema.getProperties().get(component.getName());
                if (member != null) {
                    AllowedValuesSchema.describe(component, member);
                    boolean always = !component.getAccessor().isAnnotationPresent(JsonInclude.class);
                    describe(schema, component, member, whole && always, nulls && always);
                }
            }
        }));
    }

    @SuppressWarnings("unchecked")
    private static void describe(
            Schema<?> schema, RecordComponent component, Schema<?> member, boolean whole, boolean nulls) {
        String name = component.getName();
        boolean nullable = component.getAnnotatedType().isAnnotationPresent(Nullable.class);
        if (whole && member.getItems() != null && holdsNulls(component)) {
            member.setItems(orNull(member.getItems()));
        }
        boolean required = schema.getRequired() != null && schema.getRequired().contains(name);
        if (nullable && nulls && (whole || !required)) {
            schema.getProperties().put(name, orNull(member));
        }
        if (!required && (whole || !nullable)) {
            schema.addRequiredItem(name);
        }
    }

    private static boolean holdsNulls(RecordComponent list) {
        return list.getAnnotatedType() instanceof AnnotatedParameterizedType of
                && of.getAnnotatedActualTypeArguments()[0].isAnnotationPresent(Nullable.class);
    }

    @SuppressWarnings("unchecked")
    private static Schema<?> orNull(Schema<?> member) {
        if (member.get$ref() == null) {
            if (member.getTypes() != null) {
                Set<String> types = new LinkedHashSet<>(member.getTypes());
                types.add(NULL);
                member.setTypes(types);
            }
            if (member.getEnum() != null) {
                List<@Nullable Object> values = new ArrayList<>(member.getEnum());
                values.add(null);
                ((Schema<@Nullable Object>) member).setEnum(values);
            }
            return member;
        }
        Schema<Object> reference = new Schema<>();
        reference.set$ref(member.get$ref());
        Schema<Object> nothing = new Schema<>();
        nothing.addType(NULL);
        Schema<Object> either = new Schema<>();
        either.setDescription(member.getDescription());
        either.setAnyOf(List.of(reference, nothing));
        return either;
    }

    /** The schemas of what clients send, and of all that is in it. */
    private static Set<String> sent(OpenAPI description) {
        Set<String> found = new HashSet<>();
        List<Schema<?>> open = new ArrayList<>(description.getPaths().values().stream()
                .flatMap(path -> path.readOperations().stream())
                .flatMap(NullabilityCustomizer::bodies)
                .toList());
        while (!open.isEmpty()) {
            Schema<?> schema = open.remove(open.size() - 1);
            String reference = schema.get$ref();
            if (reference == null) {
                open.addAll(parts(schema));
            } else if (found.add(reference.substring(REFERENCE.length()))) {
                open.add(description.getComponents().getSchemas().get(reference.substring(REFERENCE.length())));
            }
        }
        return found;
    }

    private static Stream<Schema<?>> bodies(Operation operation) {
        Content content = operation.getRequestBody() == null
                ? null
                : operation.getRequestBody().getContent();
        return content == null
                ? Stream.empty()
                : content.values().stream()
                        .<Schema<?>>map(media -> media.getSchema())
                        .filter(Objects::nonNull);
    }

    @SuppressWarnings({"rawtypes", "unchecked"})
    private static List<Schema<?>> parts(Schema schema) {
        List<Schema<?>> parts = new ArrayList<>();
        if (schema.getProperties() != null) {
            parts.addAll(((Map<String, Schema<?>>) schema.getProperties()).values());
        }
        if (schema.getItems() != null) {
            parts.add(schema.getItems());
        }
        if (schema.getAdditionalProperties() instanceof Schema<?> values) {
            parts.add(values);
        }
        Stream.of(schema.getAnyOf(), schema.getOneOf(), schema.getAllOf())
                .filter(Objects::nonNull)
                .forEach(all -> parts.addAll((List<Schema<?>>) all));
        return parts;
    }
}
