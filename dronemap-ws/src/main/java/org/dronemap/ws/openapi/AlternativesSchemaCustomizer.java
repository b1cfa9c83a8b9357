package org.dronemap.ws.openapi;

import com.fasterxml.jackson.databind.JavaType;
import io.swagger.v3.core.converter.AnnotatedType;
import io.swagger.v3.core.converter.ModelConverter;
import io.swagger.v3.core.converter.ModelConverterContext;
import io.swagger.v3.core.util.Json;
import io.swagger.v3.oas.models.OpenAPI;
import io.swagger.v3.oas.models.media.Discriminator;
import io.swagger.v3.oas.models.media.Schema;
import io.swagger.v3.oas.models.media.StringSchema;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronemap.ws.reading.RecordAlternatives;
import org.jspecify.annotations.Nullable;
import org.springdoc.core.customizers.OpenApiCustomizer;

/**
 * Describes a body that is one of several records in OpenAPI: a oneOf with the discriminating member. The usual reader
 * would describe each of them as all that the others are as well.
 */
public final class AlternativesSchemaCustomizer implements ModelConverter, OpenApiCustomizer {
    private static final String REFERENCE = "#/components/schemas/";

    private final RecordSchemaRegistry records;

    public AlternativesSchemaCustomizer(RecordSchemaRegistry records) {
        this.records = records;
    }

    @Override
    public @Nullable Schema<?> resolve(
            AnnotatedType type, ModelConverterContext context, Iterator<ModelConverter> chain) {
        JavaType java = Json.mapper().constructType(type.getType());
        Class<?> raw = java == null ? Object.class : java.getRawClass();
        RecordAlternatives all = RecordAlternatives.of(raw).orElse(null);
        if (all == null) {
            return chain.hasNext() ? chain.next().resolve(type, context, chain) : null;
        }
        io.swagger.v3.oas.annotations.media.Schema said =
                raw.getAnnotation(io.swagger.v3.oas.annotations.media.Schema.class);
        if (said == null || said.name().isEmpty()) {
            throw new IllegalStateException(raw.getName() + " has no name for clients: say @Schema(name = ...) there.");
        }
        context.defineModel(said.name(), choice(raw, all, said.description(), context));
        Schema<Object> reference = new Schema<>();
        reference.set$ref(REFERENCE + said.name());
        return reference;
    }

    private static Schema<?> choice(
            Class<?> raw, RecordAlternatives all, String description, ModelConverterContext context) {
        Schema<Object> choice = new Schema<>();
        choice.setDescription(description);
        // One that is itself among the alternatives of another choice.
        addDiscriminator(RecordAlternatives.discriminators(raw), choice);
        Discriminator discriminator = new Discriminator().propertyName(all.member());
        all.records().forEach((name, record) -> {
            Schema<?> one = context.resolve(new AnnotatedType(record).resolveAsRef(true));
            choice.addOneOfItem(one);
            discriminator.mapping(name, one.get$ref());
        });
        choice.setDiscriminator(discriminator);
        return choice;
    }

    @Override
    @SuppressWarnings("rawtypes")
    public void customise(OpenAPI description) {
        Map<String, Schema> schemas = description.getComponents().getSchemas();
        schemas.forEach((name, schema) -> records.of(name)
                .ifPresent(record -> addDiscriminator(RecordAlternatives.discriminators(record), schema)));
    }

    private static void addDiscriminator(Map<String, String> told, Schema<?> schema) {
        told.forEach((member, value) -> {
            Schema<String> one = new StringSchema();
            one.setTypes(Set.of("string"));
            one.setEnum(List.of(value));
            // The usual reader says nothing of a record without members.
            schema.setTypes(Set.of("object"));
            schema.addProperty(member, one);
            schema.addRequiredItem(member);
            schema.setDiscriminator(null);
        });
    }
}
