package org.dronemap.ws.wire;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.ws.reading.JsonCodec;
import org.dronemap.ws.reading.RecordAlternatives;
import org.dronemap.ws.stream.StreamFace;
import org.dronemap.ws.stream.StreamMessage;
import org.dronemap.ws.stream.StreamTopic;
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
    private static final String PACKAGE = "org.dronemap.ws.stream.";
    private final JsonMapper json = new JsonCodec().mapper();

    @Test
    void saysWhatIsApproved() {
        Map<String, String> kinds = shapes(said());

        assertThat(kinds).hasSizeGreaterThan(20);
        ApprovalFiles.checkFolder("stream/says", kinds);
    }

    @Test
    void hearsWhatIsApproved() throws ClassNotFoundException {
        ApprovalFiles.checkFolder("stream/hears", shapes(closed("StreamRequest")));
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

    /** Those of the cloud itself, and those that topics of use cases have of their own. */
    private static Map<String, Class<?>> said() {
        Map<String, Class<?>> records = new TreeMap<>(
                RecordAlternatives.of(StreamMessage.class).orElseThrow().records());
        assertThat(StreamMessage.class.getPermittedSubclasses())
                .containsExactlyInAnyOrderElementsOf(
                        Stream.concat(records.values().stream(), Stream.of(StreamMessage.OfUseCase.class))
                                .toList());
        for (StreamTopic<?> topic : SharedServer.get().bean(StreamFace.class).topics()) {
            for (Class<?> message : topic.messages()) {
                records.put(RecordAlternatives.with(message).orElseThrow().nameOf(message), message);
            }
        }
        return records;
    }

    private static Map<String, Class<?>> closed(String sealed) throws ClassNotFoundException {
        Class<?> type = Class.forName(PACKAGE + sealed);
        Map<String, Class<?>> records =
                RecordAlternatives.of(type).orElseThrow().records();
        assertThat(records.values()).containsExactlyInAnyOrder(type.getPermittedSubclasses());
        return records;
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
    void hearsEachKindThatIsDescribedAndNamesAllOfThemToWhoSaysAnother() throws ClassNotFoundException {
        Set<String> kinds = RecordAlternatives.of(Class.forName(PACKAGE + "StreamRequest"))
                .orElseThrow()
                .records()
                .keySet();
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
