package org.dronemap.ws.wire;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.Collection;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.ws.reading.JsonCodec;
import org.dronemap.ws.reading.RecordAlternatives;
import org.dronemap.ws.stream.StreamFace;
import org.dronemap.ws.stream.StreamMessage;
import org.dronemap.ws.stream.StreamRequest;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.SharedServer;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.dronemap.ws.wiring.StreamPort;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Each kind of message of the stream, with each of its members, read off the records that it is written from. */
class StreamWireTest {
    private final JsonMapper json = new JsonCodec().mapper();

    @Test
    void saysWhatIsApproved() {
        Map<String, String> kinds = shapes(said());

        assertThat(kinds).hasSizeGreaterThan(20);
        ApprovalFiles.checkFolder("stream/says", kinds);
    }

    @Test
    void hearsWhatIsApproved() {
        ApprovalFiles.checkFolder("stream/hears", shapes(requests()));
    }

    /** The description that programs are written from, to the letter. */
    @Test
    void isDescribedAsApproved() {
        TestServer house = SharedServer.get();
        TestHttpClient.Answer answer = new TestHttpClient(house, "").get("/api/asyncapi.json");
        assertThat(answer.status()).isEqualTo(200);
        String served = answer.raw()
                .body()
                .replace("127.0.0.1:" + house.bean(StreamPort.class).number(), "dronemap.example:8081");

        ApprovalFiles.check("asyncapi.json", PrettyJson.of(PrettyJson.sorted(PrettyJson.tree(served))));
    }

    /** Those of the stream itself, and those that features declare. */
    private static Map<String, Class<?>> said() {
        Map<String, Class<?>> records = new TreeMap<>(
                RecordAlternatives.of(StreamMessage.class).orElseThrow().records());
        assertThat(StreamMessage.class.getPermittedSubclasses())
                .containsExactlyInAnyOrderElementsOf(
                        Stream.concat(records.values().stream(), Stream.of(StreamMessage.OfUseCase.class))
                                .toList());
        SharedServer.get().bean(StreamFace.class).messages().ofUseCases().forEach((type, message) -> {
            assertThat(RecordAlternatives.with(message).orElseThrow().nameOf(message))
                    .isEqualTo(type);
            records.put(type, message);
        });
        return records;
    }

    private static Map<String, Class<?>> requests() {
        Map<String, Class<?>> records = SharedServer.get()
                .bean(StreamFace.class)
                .requests()
                .alternatives()
                .records();
        assertThat(records.values()).containsAll(own());
        return records;
    }

    /** Those that the stream carries out itself. */
    private static Collection<Class<?>> own() {
        return RecordAlternatives.of(StreamRequest.class)
                .orElseThrow()
                .records()
                .values();
    }

    private Map<String, String> shapes(Map<String, Class<?>> records) {
        Map<String, String> shapes = new TreeMap<>();
        records.forEach((kind, form) -> RecordAlternatives.of(form)
                .ifPresentOrElse(
                        more -> more.records()
                                .forEach((name, record) ->
                                        shapes.put(kind + "-" + name + ".txt", RecordShape.of(record, json))),
                        () -> shapes.put(kind + ".txt", RecordShape.of(form, json))));
        return shapes;
    }

    @Test
    void hearsEachKindThatIsDescribedAndNamesAllOfThemToWhoSaysAnother() {
        Set<String> kinds = requests().keySet();
        try (TestTenant tenant = new TestTenant();
                RecordingStreamClient stream =
                        RecordingStreamClient.withKey(tenant.server(), tenant.key(Role.OPERATOR))) {
            stream.await(message -> message.path("type").asString("").equals("hello"));
            for (String kind : kinds) {
                stream.send(asked(kind, kind));
            }
            stream.send(asked("no such kind", "the end"));
            JsonNode end = stream.await(
                    message -> message.path("requestId").asString("").equals("the end"));

            assertThat(end.path("problem").path("allowed").asString())
                    .isEqualTo(String.join(", ", kinds).replaceFirst(", (\\w+)$", " or $1"));
            assertThat(stream.heard().stream()
                            .filter(message -> message.path("problem")
                                    .path("field")
                                    .asString("")
                                    .equals("type"))
                            .map(message -> message.path("requestId").asString("")))
                    .containsExactly("the end");
        }
    }

    private String asked(String kind, String requestId) {
        return json.createObjectNode()
                .put("type", kind)
                .put("requestId", requestId)
                .toString();
    }

    /** What a robot says and hears, in both layouts. */
    @Test
    void speaksToRobotsAsApproved() throws IOException {
        TreeMap<String, String> spoken = new TreeMap<>();
        spoken.put("says.json", RobotProtocolDescription.said());
        spoken.put("hears.txt", RobotProtocolDescription.heard());

        ApprovalFiles.checkFolder("stream/robots", spoken);
    }
}
