package org.dronemap.ws.openapi;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import io.swagger.v3.core.converter.AnnotatedType;
import io.swagger.v3.core.converter.ModelConverters;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.models.Components;
import io.swagger.v3.oas.models.OpenAPI;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

@SuppressWarnings("rawtypes")
class AlternativesSchemaCustomizerTest {
    private static final String AT = "#/components/schemas/";

    @JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "form")
    @JsonSubTypes({
        @JsonSubTypes.Type(value = Square.class, name = "square"),
        @JsonSubTypes.Type(value = Disc.class, name = "disc"),
        @JsonSubTypes.Type(value = Nothing.class, name = "nothing")
    })
    @Schema(name = "Shape", description = "What is drawn.")
    private sealed interface Shape {
        @Schema(description = "What it is called")
        @Nullable
        String label();
    }

    @Schema(name = "SquareShape")
    private record Square(int side, @Nullable String label) implements Shape {}

    @Schema(name = "DiscShape")
    private record Disc(int radius, @Nullable String label) implements Shape {}

    @Schema(name = "NothingShape")
    private record Nothing() implements Shape {
        @Override
        public @Nullable String label() {
            return null;
        }
    }

    @Schema(name = "Drawing")
    private record Drawing(List<Shape> shapes) {}

    @JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "form")
    @JsonSubTypes(@JsonSubTypes.Type(value = Dot.class, name = "dot"))
    private sealed interface Nameless {}

    @Schema(name = "DotShape")
    private record Dot() implements Nameless {}

    @JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "does")
    @JsonSubTypes(@JsonSubTypes.Type(value = Move.class, name = "move"))
    @Schema(name = "Order", description = "What is to be done.")
    private sealed interface Order {}

    @JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "way")
    @JsonSubTypes(@JsonSubTypes.Type(value = Walk.class, name = "walk"))
    @Schema(name = "MoveOrder", description = "Goes there.")
    private sealed interface Move extends Order {}

    @Schema(name = "WalkOrder")
    private record Walk(int speed) implements Move {}

    private static Map<String, io.swagger.v3.oas.models.media.Schema> described(Class<?> type) {
        RecordSchemaRegistry records = new RecordSchemaRegistry();
        AlternativesSchemaCustomizer alternatives = new AlternativesSchemaCustomizer(records);
        ModelConverters converters = new ModelConverters(true);
        converters.addConverter(alternatives);
        converters.addConverter(records);
        OpenAPI description =
                new OpenAPI().components(new Components().schemas(converters.readAll(new AnnotatedType(type))));
        alternatives.customise(description);
        return description.getComponents().getSchemas();
    }

    @Test
    void areAChoiceByTheMemberThatTellsThemApart() {
        io.swagger.v3.oas.models.media.Schema<?> shape =
                described(Drawing.class).get("Shape");

        assertThat(shape.getDescription()).isEqualTo("What is drawn.");
        assertThat(shape.getOneOf())
                .extracting(io.swagger.v3.oas.models.media.Schema::get$ref)
                .containsExactly(AT + "SquareShape", AT + "DiscShape", AT + "NothingShape");
        assertThat(shape.getDiscriminator().getPropertyName()).isEqualTo("form");
        assertThat(shape.getDiscriminator().getMapping())
                .containsExactly(
                        Map.entry("square", AT + "SquareShape"),
                        Map.entry("disc", AT + "DiscShape"),
                        Map.entry("nothing", AT + "NothingShape"));
        assertThat(shape.getProperties()).isNull();
    }

    @Test
    void haveThatMemberWithTheirOneValueBesideTheirOwn() {
        io.swagger.v3.oas.models.media.Schema<?> disc = described(Drawing.class).get("DiscShape");

        assertThat(disc.getProperties().keySet()).containsExactlyInAnyOrder("radius", "label", "form");
        assertThat(member(disc, "form").getEnum()).map(Object::toString).containsExactly("disc");
        assertThat(member(disc, "label").getDescription()).isEqualTo("What it is called");
        assertThat(disc.getRequired()).contains("form");
        assertThat(disc.getAllOf()).isNull();
        assertThat(disc.getDiscriminator()).isNull();
    }

    @Test
    void areObjectsAlsoWithoutMembersOfTheirOwn() {
        io.swagger.v3.oas.models.media.Schema<?> nothing =
                described(Drawing.class).get("NothingShape");

        assertThat(nothing.getTypes()).containsExactly("object");
        assertThat(nothing.getProperties().keySet()).containsExactly("form");
    }

    @Test
    void mayBeAChoiceByAnotherMemberWhichEachOfItHasAsWell() {
        Map<String, io.swagger.v3.oas.models.media.Schema> all = described(Order.class);
        io.swagger.v3.oas.models.media.Schema<?> order = all.get("Order");
        io.swagger.v3.oas.models.media.Schema<?> move = all.get("MoveOrder");
        io.swagger.v3.oas.models.media.Schema<?> walk = all.get("WalkOrder");

        assertThat(order.getDiscriminator().getMapping()).containsExactly(Map.entry("move", AT + "MoveOrder"));
        assertThat(move.getDiscriminator().getPropertyName()).isEqualTo("way");
        assertThat(move.getDiscriminator().getMapping()).containsExactly(Map.entry("walk", AT + "WalkOrder"));
        assertThat(member(move, "does").getEnum()).map(Object::toString).containsExactly("move");
        assertThat(move.getRequired()).containsExactly("does");
        assertThat(walk.getProperties().keySet()).containsExactlyInAnyOrder("speed", "does", "way");
        assertThat(member(walk, "does").getEnum()).map(Object::toString).containsExactly("move");
        assertThat(walk.getRequired()).contains("does", "way");
    }

    private static io.swagger.v3.oas.models.media.Schema<?> member(
            io.swagger.v3.oas.models.media.Schema<?> schema, String name) {
        return (io.swagger.v3.oas.models.media.Schema<?>) schema.getProperties().get(name);
    }

    @Test
    void haveANameForClients() {
        assertThatThrownBy(() -> described(Nameless.class)).hasMessageContaining("Nameless has no name for clients");
    }
}
