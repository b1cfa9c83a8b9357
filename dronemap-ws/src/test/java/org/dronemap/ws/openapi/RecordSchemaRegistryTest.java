package org.dronemap.ws.openapi;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.swagger.v3.core.converter.AnnotatedType;
import io.swagger.v3.core.converter.ModelConverters;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.models.Components;
import io.swagger.v3.oas.models.OpenAPI;
import io.swagger.v3.oas.models.Operation;
import io.swagger.v3.oas.models.PathItem;
import io.swagger.v3.oas.models.Paths;
import io.swagger.v3.oas.models.media.Content;
import io.swagger.v3.oas.models.media.MediaType;
import io.swagger.v3.oas.models.parameters.RequestBody;
import java.lang.reflect.Type;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.dronemap.ws.reading.EnumValues;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

@SuppressWarnings("rawtypes")
class RecordSchemaRegistryTest {
    private final RecordSchemaRegistry records = new RecordSchemaRegistry();
    private final ModelConverters converters = new ModelConverters(true);

    private enum Size {
        SMALL,
        VERY_LARGE
    }

    @Schema(name = "Part")
    private record Part(int number) {}

    @Schema(name = "Whole")
    private record Whole(
            String name,
            @Nullable String note,
            @Nullable Part part,
            List<@Nullable Integer> numbers,
            @EnumValues(value = Size.class, and = "other") List<String> sizes,

            @Schema(allowableValues = {"left", "right"}) @Nullable
            String side,

            @Schema(requiredMode = Schema.RequiredMode.REQUIRED) @Nullable
            String type) {}

    @Schema(name = "Part")
    private record Another(String text) {}

    private record Nameless(String text) {}

    private Map<String, io.swagger.v3.oas.models.media.Schema> described(Type type) {
        converters.addConverter(records);
        return converters.readAll(new AnnotatedType(type));
    }

    private OpenAPI description(boolean sent) {
        OpenAPI description = new OpenAPI()
                .components(new Components().schemas(described(Whole.class)))
                .paths(new Paths());
        io.swagger.v3.oas.models.media.Schema<Object> reference = new io.swagger.v3.oas.models.media.Schema<>();
        reference.set$ref("#/components/schemas/Whole");
        Operation operation = new Operation()
                .requestBody(new RequestBody()
                        .content(new Content().addMediaType("application/json", new MediaType().schema(reference))));
        description.path("/things", sent ? new PathItem().post(operation) : new PathItem().get(new Operation()));
        new NullabilityCustomizer(records).customise(description);
        return description;
    }

    @Test
    void refusesARecordWithoutANameForClients() {
        assertThatThrownBy(() -> described(Nameless.class)).hasMessageContaining("Nameless has no name for clients");
    }

    @Test
    void refusesTwoRecordsOfOneName() {
        var unused = described(Whole.class);

        assertThatThrownBy(() -> described(Another.class))
                .hasMessageContaining("have the same name for clients: Part.");
    }

    @Test
    void saysThatAnAnswerHasAllItsMembersAndWhichMayBeNull() {
        io.swagger.v3.oas.models.media.Schema<?> whole =
                description(false).getComponents().getSchemas().get("Whole");

        assertThat(whole.getRequired())
                .containsExactlyInAnyOrder("name", "note", "part", "numbers", "sizes", "side", "type");
        assertThat(member(whole, "name").getTypes()).containsExactly("string");
        assertThat(member(whole, "note").getTypes()).containsExactly("string", "null");
        assertThat(member(whole, "type").getTypes()).containsExactly("string", "null");
        assertThat(member(whole, "numbers").getItems().getTypes()).containsExactly("integer", "null");
        assertThat(member(whole, "part").getAnyOf())
                .extracting(one -> one.get$ref() == null ? one.getTypes().toString() : one.get$ref())
                .containsExactly("#/components/schemas/Part", "[null]");
    }

    @Test
    void saysThatARequestHasWhatIsNotNullableOrSaidToBeNeeded() {
        io.swagger.v3.oas.models.media.Schema<?> whole =
                description(true).getComponents().getSchemas().get("Whole");

        assertThat(whole.getRequired()).containsExactlyInAnyOrder("name", "numbers", "sizes", "type");
        assertThat(member(whole, "type").getTypes()).containsExactly("string");
        assertThat(member(whole, "note").getTypes()).containsExactly("string", "null");
    }

    @Test
    void saysWhichValuesATextMayHave() {
        io.swagger.v3.oas.models.media.Schema<?> whole =
                description(false).getComponents().getSchemas().get("Whole");

        assertThat(member(whole, "sizes").getItems().getEnum())
                .map(Object::toString)
                .containsExactly("small", "veryLarge", "other");
        assertThat(member(whole, "side").getEnum()).map(Objects::toString).containsExactly("left", "right", "null");
    }

    private static io.swagger.v3.oas.models.media.Schema<?> member(
            io.swagger.v3.oas.models.media.Schema<?> schema, String name) {
        return (io.swagger.v3.oas.models.media.Schema<?>) schema.getProperties().get(name);
    }
}
