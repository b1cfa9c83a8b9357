package org.dronemap.ws.reading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import java.util.List;
import java.util.Map;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RejectionKind;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.annotation.JsonTypeResolver;

/** Bodies that are one of several records: which they are, and what is said where they are none. */
class RecordAlternativesTest {
    @JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "form")
    @JsonTypeResolver(ObjectOnlyTypeResolver.class)
    @JsonSubTypes({
        @JsonSubTypes.Type(value = Square.class, name = "square"),
        @JsonSubTypes.Type(value = Disc.class, name = "disc")
    })
    sealed interface Shape {}

    record Square(@Nullable Double side) implements Shape {}

    record Disc(@Nullable Double radius, @Nullable String note) implements Shape {}

    record Drawing(@Nullable Shape frame, @Nullable List<Shape> shapes) {}

    private final JsonCodec json = new JsonCodec();

    private InvalidInput wrong(String text, Class<?> type) {
        return catchThrowableOfType(InvalidInput.class, () -> json.read(text, type));
    }

    @Test
    void areKnownByTheirNamesInTheOrderInWhichTheyAreNamed() {
        RecordAlternatives all = RecordAlternatives.of(Shape.class).orElseThrow();

        assertThat(all.member()).isEqualTo("form");
        assertThat(all.records().keySet()).containsExactly("square", "disc");
        assertThat(RecordAlternatives.with(Disc.class)).contains(all);
        assertThat(all.nameOf(Disc.class)).isEqualTo("disc");
        assertThat(RecordAlternatives.of(Disc.class)).isEmpty();
        assertThat(RecordAlternatives.with(Drawing.class)).isEmpty();
    }

    @Test
    void areReadWhereverTheMemberStands() {
        assertThat(json.read("{\"radius\":2,\"form\":\"disc\"}", Shape.class)).isEqualTo(new Disc(2.0, null));
    }

    @ParameterizedTest
    @ValueSource(strings = {"{}", "{\"side\":1}", "{\"form\":null}"})
    void areToldWhereNoneIsNamed(String text) {
        InvalidInput wrong = wrong(text, Shape.class);

        assertThat(wrong.sentence()).isEqualTo("\"form\" is missing; it must be square or disc.");
        assertThat(wrong.field()).isEqualTo("form");
        assertThat(wrong.allowed()).isEqualTo("square or disc");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '\0',
            value = {
                "{\"frame\":{\"form\":\"ring\"}} | frame.form | ring",
                "{\"shapes\":[{\"form\":\"disc\"},{\"form\":\"ring\"}]} | shapes[1].form | ring",
                "{\"frame\":{\"form\":7}} | frame.form | 7"
            })
    void areToldWithThePlaceWhereAnotherIsNamed(String text, String field, String said) {
        InvalidInput wrong = wrong(text, Drawing.class);

        assertThat(wrong.field()).isEqualTo(field);
        assertThat(wrong.sentence()).isEqualTo("\"" + field + "\" must be square or disc, not \"" + said + "\".");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "{\"form\":\"disc\",\"side\":1}",
                "{\"form\":\"disc\",\"side\":null}",
                "{\"side\":1,\"form\":\"disc\"}"
            })
    void haveTheirOwnMembersAndNoOthers(String text) {
        InvalidInput wrong = wrong(text, Shape.class);

        assertThat(wrong.field()).isEqualTo("side");
        assertThat(wrong.sentence()).isEqualTo("There is no member \"side\" here; there are: form, radius, note.");
    }

    @ParameterizedTest
    @ValueSource(strings = {"[]", "[\"disc\",{\"radius\":2}]", "\"disc\"", "7"})
    void areObjectsAndNothingElse(String text) {
        Rejection wrong = catchThrowableOfType(Rejection.class, () -> json.read(text, Shape.class));

        assertThat(wrong.kind()).isEqualTo(RejectionKind.MALFORMED);
        assertThat(wrong.sentence()).isEqualTo("A JSON object is needed here.");
    }

    @JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "does")
    @JsonTypeResolver(ObjectOnlyTypeResolver.class)
    @JsonSubTypes({
        @JsonSubTypes.Type(value = Wait.class, name = "wait"),
        @JsonSubTypes.Type(value = Move.class, name = "move")
    })
    sealed interface Order {}

    record Wait() implements Order {}

    @JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "way")
    @JsonTypeResolver(ObjectOnlyTypeResolver.class)
    @JsonSubTypes({
        @JsonSubTypes.Type(value = Walk.class, name = "walk"),
        @JsonSubTypes.Type(value = Jump.class, name = "jump")
    })
    sealed interface Move extends Order {}

    record Walk(@Nullable Double speed) implements Move {}

    record Jump(@Nullable Double height, @Nullable List<String> cries) implements Move {}

    @Test
    void mayBeAChoiceByAnotherMember() {
        assertThat(RecordAlternatives.of(Order.class).orElseThrow().records())
                .containsExactly(Map.entry("wait", Wait.class), Map.entry("move", Move.class));
        assertThat(RecordAlternatives.discriminators(Jump.class))
                .containsExactly(Map.entry("does", "move"), Map.entry("way", "jump"));
        assertThat(RecordAlternatives.discriminators(Wait.class)).containsExactly(Map.entry("does", "wait"));
        assertThat(RecordAlternatives.discriminators(Drawing.class)).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "{\"does\":\"move\",\"way\":\"jump\",\"height\":2,\"cries\":[\"hey\"]}",
                "{\"way\":\"jump\",\"does\":\"move\",\"height\":2,\"cries\":[\"hey\"]}",
                "{\"height\":2,\"cries\":[\"hey\"],\"way\":\"jump\",\"does\":\"move\"}",
                "{\"cries\":[\"hey\"],\"does\":\"move\",\"height\":2,\"way\":\"jump\"}"
            })
    void areReadWhereverBothMembersStand(String text) {
        assertThat(json.read(text, Order.class)).isEqualTo(new Jump(2.0, List.of("hey")));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '\0',
            value = {
                "{\"does\":\"move\"} | \"way\" is missing; it must be walk or jump.",
                "{\"speed\":1,\"does\":\"move\"} | \"way\" is missing; it must be walk or jump.",
                "{\"does\":\"move\",\"way\":\"fly\"} | \"way\" must be walk or jump, not \"fly\".",
                "{\"does\":\"wait\",\"way\":\"jump\"} | There is no member \"way\" here; there are: does.",
                "{\"does\":\"move\",\"way\":\"walk\",\"height\":1} | There is no member \"height\" here; there are: does,"
                        + " way, speed."
            })
    void areToldWhatIsWrongInTheInnerChoice(String text, String sentence) {
        assertThat(wrong(text, Order.class).sentence()).isEqualTo(sentence);
    }
}
