package org.dronemap.ws.stream;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.annotation.JsonTypeName;
import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import java.util.stream.Stream;
import org.dronemap.ws.environment.SetupException;
import org.dronemap.ws.reading.JsonCodec;
import org.dronemap.ws.reading.RecordAlternatives;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.springframework.core.annotation.Order;

/** Messages of topics that are declared beside their use cases: which they are, and which the server does not start with. */
class StreamMessageCatalogueTest {
    @JsonTypeName("painted")
    @Schema(name = "StreamPainted", description = "A thing that was painted.")
    record Painted(String id, String colour) implements StreamMessage.OfUseCase {}

    @JsonTypeName("unpainted")
    @Schema(name = "StreamUnpainted", description = "A thing that was bared.")
    record Unpainted(String id) implements StreamMessage.OfUseCase {}

    @JsonTypeName("primed")
    @Order(1)
    @Schema(name = "StreamPrimed", description = "A thing that is ready to be painted.")
    record Primed(String id) implements StreamMessage.OfUseCase {}

    @JsonTypeName("painted")
    @Schema(name = "StreamPaintedAgain", description = "Another one of the same type.")
    record PaintedAgain(String id) implements StreamMessage.OfUseCase {}

    @JsonTypeName("pong")
    @Schema(name = "StreamTable", description = "One of a type that the cloud itself has.")
    record Table(String id) implements StreamMessage.OfUseCase {}

    @Schema(name = "StreamUntyped", description = "One without a type.")
    record Untyped(String id) implements StreamMessage.OfUseCase {}

    @JsonTypeName("nameless")
    record Nameless(String id) implements StreamMessage.OfUseCase {}

    private static StreamTopic<String> topic(
            Class<? extends StreamMessage> message,
            String kind,
            StreamTopicRate rate,
            StreamTopic.@Nullable Removal removal) {
        return new StreamTopic<>(
                message,
                rate,
                new StreamTopic.SubjectMapping<>(kind, thing -> thing),
                StreamTopic.Audience.of("everybody", (who, thing) -> true),
                (thing, who) -> new Painted(thing, "red"),
                List::of,
                removal,
                told -> {});
    }

    private static StreamTopic<String> newest(Class<? extends StreamMessage> message, String kind) {
        return topic(message, kind, new StreamTopicRate.Newest(2), null);
    }

    @Test
    void areThoseOfTheCloudAndThoseOfTopics() {
        StreamTopic<String> painted = topic(
                Painted.class,
                "wall",
                new StreamTopicRate.EveryChange(),
                new StreamTopic.Removal(Unpainted.class, Unpainted::new));
        StreamMessageCatalogue said = StreamMessageCatalogue.of(List.of(painted), List.of());

        assertThat(said.ofUseCases())
                .containsEntry("painted", Painted.class)
                .containsEntry("unpainted", Unpainted.class)
                .hasSize(2);
        assertThat(said.records())
                .containsAllEntriesOf(
                        RecordAlternatives.of(StreamMessage.class).orElseThrow().records())
                .containsAllEntriesOf(said.ofUseCases());
    }

    @Test
    void areWrittenWithTheirTypeLikeAllOthers() {
        JsonCodec json = new JsonCodec();

        assertThat(json.write(new Painted("a", "red")))
                .isEqualTo("{\"type\":\"painted\",\"id\":\"a\",\"colour\":\"red\"}");
        assertThat(json.write(new StreamMessage.Hello("a", "viewer", "1.2")))
                .isEqualTo("{\"type\":\"hello\",\"user\":\"a\",\"role\":\"viewer\",\"version\":\"1.2\"}");
    }

    @Test
    void mayBeOfADroneThatOtherTopicsAreAboutToo() {
        List<StreamTopic<?>> topics = List.of(
                newest(Unpainted.class, "drone"),
                topic(Painted.class, "drone", new StreamTopicRate.EveryChange(), null));

        assertThat(StreamMessageCatalogue.of(topics, List.of()).ofUseCases()).containsOnlyKeys("unpainted", "painted");
    }

    /** So that the description does not depend on who declares what. */
    @Test
    void areDescribedInTheirOrderBetweenWhatTheStreamSaysOfItself() {
        StreamMessageCatalogue said = StreamMessageCatalogue.of(
                List.of(newest(Painted.class, "wall"), newest(Unpainted.class, "door")),
                List.of(Primed.class, Unpainted.class));

        assertThat(said.records().keySet())
                .containsExactly("hello", "primed", "painted", "unpainted", "error", "ping", "pong");
    }

    @Test
    void doNotStartWhereAnAnswerHasTheTypeOfAnother() {
        assertThatThrownBy(() -> StreamMessageCatalogue.of(List.of(), List.of(Painted.class, PaintedAgain.class)))
                .isInstanceOf(SetupException.class)
                .hasMessageContaining("Two messages of the stream are of the type painted");
    }

    record Faulty(List<StreamTopic<?>> topics, String sentence) {}

    static Stream<Faulty> faulty() {
        String here = StreamMessageCatalogueTest.class.getName() + "$";
        return Stream.of(
                new Faulty(
                        List.of(newest(Painted.class, "wall"), newest(PaintedAgain.class, "door")),
                        "Two topics of the stream tell messages of the type painted: " + here + "Painted and " + here
                                + "PaintedAgain; each message needs a type of its own."),
                new Faulty(
                        List.of(newest(Painted.class, "wall"), newest(Painted.class, "door")),
                        "Two topics of the stream tell messages of the type painted: " + here + "Painted and " + here
                                + "Painted; each message needs a type of its own."),
                new Faulty(
                        List.of(newest(Table.class, "table")),
                        "Two topics of the stream tell messages of the type pong: " + StreamMessage.Pong.class.getName()
                                + " and " + here + "Table; each message needs a type of its own."),
                new Faulty(
                        List.of(newest(Painted.class, "wall"), newest(Unpainted.class, "wall")),
                        "Two topics of the stream are about things of the kind wall: those of " + here
                                + "Painted and of " + here + "Unpainted; each topic needs a kind of its own."),
                new Faulty(
                        List.of(newest(Untyped.class, "wall")),
                        here + "Untyped has no type for clients: say @JsonTypeName(...) there."),
                new Faulty(
                        List.of(newest(Nameless.class, "wall")),
                        here + "Nameless has no name for clients that begins with Stream, or no description: say"
                                + " @Schema(name = ..., description = ...) there."));
    }

    @ParameterizedTest
    @MethodSource("faulty")
    void doNotStartWhereTheyCouldNotBeToldFromEachOther(Faulty faulty) {
        assertThatThrownBy(() -> StreamMessageCatalogue.of(faulty.topics(), List.of()))
                .isInstanceOf(SetupException.class)
                .hasMessage(faulty.sentence());
    }
}
