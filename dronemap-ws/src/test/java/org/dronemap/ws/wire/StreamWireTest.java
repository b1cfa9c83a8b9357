package org.dronemap.ws.wire;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.dronemap.core.access.Role;
import org.dronemap.ws.house.StreamListener;
import org.dronemap.ws.house.Tenant;
import org.dronemap.ws.service.JsonReader;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Each kind of message of the stream, with each of its members, read off the records that it is written from. */
class StreamWireTest {
    private static final String PACKAGE = "org.dronemap.ws.stream.";
    private final JsonMapper json = new JsonReader().mapper();

    @Test
    void saysWhatIsApproved() throws ClassNotFoundException {
        TreeMap<String, String> kinds = new TreeMap<>();
        for (Class<?> message : Class.forName(PACKAGE + "StreamMessage").getDeclaredClasses()) {
            if (message.isRecord() && !message.getSimpleName().equals("FromClient")) {
                String shape = RecordShape.of(message, json);
                JsonNode sample = json.valueToTree(new RecordSample(true).of(message));
                String former = kinds.put(sample.path("type").asString() + ".txt", shape);
                assertThat(former).as("another kind is called as " + message).isNull();
            }
        }

        assertThat(kinds).hasSizeGreaterThan(20);
        Approved.checkFolder("stream/says", kinds);
    }

    @Test
    void hearsTheMembersThatAreApproved() throws ClassNotFoundException {
        Approved.check(
                "stream/hears-members.txt", RecordShape.of(Class.forName(PACKAGE + "StreamMessage$FromClient"), json));
    }

    /** Each word in the class that takes messages is tried: none that it takes as a type can be forgotten here. */
    @Test
    void hearsTheKindsThatAreApproved() throws IOException {
        Set<String> kinds = new TreeSet<>(ConstantWords.of(PACKAGE + "StreamRequests"));
        try (Tenant tenant = new Tenant();
                StreamListener stream = StreamListener.withKey(tenant.server(), tenant.key(Role.OPERATOR))) {
            stream.await(message -> message.path("type").asString("").equals("hello"));
            for (String kind : kinds) {
                stream.send(asked(kind, kind));
            }
            stream.send(asked("no such kind", "the end"));
            stream.await(message -> message.path("requestId").asString("").equals("the end"));
            Set<String> refused = stream.heard().stream()
                    .filter(message ->
                            message.path("problem").path("field").asString("").equals("type"))
                    .map(message -> message.path("requestId").asString(""))
                    .collect(Collectors.toSet());
            kinds.removeAll(refused);
        }

        assertThat(kinds).isNotEmpty();
        Approved.check("stream/hears-kinds.txt", String.join("\n", kinds) + "\n");
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
        spoken.put("says.json", RobotWords.said());
        spoken.put("hears.txt", RobotWords.heard());

        Approved.checkFolder("stream/robots", spoken);
    }
}
