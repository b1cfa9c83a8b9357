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

/** Requests that are declared beside their use cases: how they are read, and which the server does not start with. */
class StreamRequestCatalogueTest {
    @JsonTypeName("paint")
    @Schema(name = "StreamPaintRequest", description = "Paints a thing.")
    record Paint(@Nullable String requestId, @Nullable String colour) implements StreamRequest.OfUseCase {}

    @JsonTypeName("paint")
    @Schema(name = "StreamPaintAgainRequest", description = "Another one of the same type.")
    record PaintAgain(@Nullable String requestId) implements StreamRequest.OfUseCase {}

    @JsonTypeName("ping")
    @Schema(name = "StreamKnockRequest", description = "One of a type that the stream itself has.")
    record Knock(@Nullable String requestId) implements StreamRequest.OfUseCase {}

    @Schema(name = "StreamUntypedRequest", description = "One without a type.")
    record Untyped(@Nullable String requestId) implements StreamRequest.OfUseCase {}

    @JsonTypeName("nameless")
    record Nameless(@Nullable String requestId) implements StreamRequest.OfUseCase {}

    private static <R extends StreamRequest.OfUseCase> StreamOperation<R> operation(Class<R> request) {
        return StreamOperation.of(
                new StreamRequestType<>(request, new StreamAccessRule.OfOperation<>("paintThing"), null),
                (connection, principal, one) -> null);
    }

    @Test
    void areReadLikeThoseOfTheStreamItself() {
        StreamRequestCatalogue requests = StreamRequestCatalogue.of(List.of(operation(Paint.class)));
        JsonCodec reader = requests.reader(new JsonCodec());

        StreamRequest paint =
                reader.read("{\"type\":\"paint\",\"requestId\":\"1\",\"colour\":\"red\"}", StreamRequest.class);
        StreamRequest ping = reader.read("{\"type\":\"ping\"}", StreamRequest.class);

        assertThat(paint).isEqualTo(new Paint("1", "red"));
        assertThat(ping).isEqualTo(new StreamRequest.Ping(null));
        assertThat(requests.nameOf(paint)).isEqualTo("paint");
        assertThat(requests.operation(paint)).isPresent();
        assertThat(requests.operation(ping)).isEmpty();
    }

    @Test
    void areNamedBetweenThoseOfTheStreamItself() {
        StreamRequestCatalogue requests = StreamRequestCatalogue.of(List.of(operation(Paint.class)));

        assertThat(requests.alternatives().allowed()).isEqualTo("authenticate, paint, subscribe or ping");
        assertThat(requests.alternatives().records().values())
                .containsAll(RecordAlternatives.of(StreamRequest.class)
                        .orElseThrow()
                        .records()
                        .values());
    }

    @Test
    @SuppressWarnings("NullAway")
    void areNoneWithoutAnAccessRule() {
        assertThatThrownBy(() -> new StreamRequestType<>(Paint.class, null, null))
                .hasMessage(Paint.class.getName() + " has no access rule: say who may send it.");
    }

    record Faulty(List<StreamOperation<?>> operations, String sentence) {}

    static Stream<Faulty> faulty() {
        String here = StreamRequestCatalogueTest.class.getName() + "$";
        return Stream.of(
                new Faulty(
                        List.of(operation(Paint.class), operation(PaintAgain.class)),
                        "Two requests of the stream are of the type paint: " + here + "Paint and " + here
                                + "PaintAgain; each request needs a type of its own."),
                new Faulty(
                        List.of(operation(Paint.class), operation(Paint.class)),
                        "Two requests of the stream are of the type paint: " + here + "Paint and " + here
                                + "Paint; each request needs a type of its own."),
                new Faulty(
                        List.of(operation(Knock.class)),
                        "Two requests of the stream are of the type ping: " + here + "Knock and "
                                + StreamRequest.Ping.class.getName() + "; each request needs a type of its own."),
                new Faulty(
                        List.of(operation(Untyped.class)),
                        here + "Untyped has no type for clients: say @JsonTypeName(...) there."),
                new Faulty(
                        List.of(operation(Nameless.class)),
                        here + "Nameless has no name for clients of the form Stream...Request, or no description: say"
                                + " @Schema(name = ..., description = ...) there."));
    }

    @ParameterizedTest
    @MethodSource("faulty")
    void doNotStartWhereTheyCouldNotBeToldFromEachOther(Faulty faulty) {
        assertThatThrownBy(() -> StreamRequestCatalogue.of(faulty.operations()))
                .isInstanceOf(SetupException.class)
                .hasMessage(faulty.sentence());
    }
}
