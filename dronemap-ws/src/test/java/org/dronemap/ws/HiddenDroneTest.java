package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.session.FrameTap;
import org.dronemap.ws.testserver.ConditionWait;
import org.dronemap.ws.testserver.ExposedOperations;
import org.dronemap.ws.testserver.ImmediateCopter;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tools.jackson.databind.JsonNode;

/**
 * Whoever holds virtual drones alone asks the running server for everything that it exposes, about the drone that serves and
 * about none, while it is waited for, flown and taken away; and finds nothing in any answer, error, message or export that
 * tells which one it is.
 */
class HiddenDroneTest {
    private static final String PATH = "/api/v1/virtual-drones";
    private static final String ABSENT = "absent-thing";
    private static final String MISSION = "\"items\":[{\"type\":\"waypoint\",\"latitude\":47.398,\"longitude\":8.5456,"
            + "\"altitude\":20},{\"type\":\"waypoint\",\"latitude\":47.399,\"longitude\":8.5456,\"altitude\":20}]";
    private static final String ZONE =
            "{\"type\":\"Feature\",\"geometry\":{\"type\":\"Point\",\"coordinates\":[10,60]},"
                    + "\"properties\":{\"name\":\"Theirs\",\"kind\":\"exclusion\",\"radius\":50,\"drone\":\"%s\"}}";
    /** These end what is looked at, or the look itself. */
    private static final Pattern ENDING =
            Pattern.compile("(PUT|DELETE|POST) " + PATH + "/.*|.*/session.*|.*/access-keys/.*");

    private final Map<String, String> heard = new LinkedHashMap<>();
    private static TestServer house;
    private static ExposedOperations faces;
    private static TestHttpClient supervisor;
    private DroneKey key;
    private String name;

    @BeforeAll
    static void open(@TempDir Path data) {
        house = new TestServer(data, false);
        faces = new ExposedOperations(house);
        supervisor = new TestHttpClient(house, house.key(Role.SUPERVISOR));
    }

    @AfterAll
    static void close() {
        house.close();
    }

    @ParameterizedTest
    @EnumSource(names = {"OPERATOR", "ADMINISTRATOR"})
    void isToldByNoAnswerMessageErrorOrExport(Role role) {
        String secret = house.key(role);
        TestHttpClient holder = new TestHttpClient(house, secret);
        grantVirtualDronesAlone(holder);
        // Each has words of its own, that no other one is found by.
        key = new DroneKey("10.9.8." + (7 + role.ordinal()), 14_607 + role.ordinal(), 217 + role.ordinal());
        name = "Falcon of " + role;
        ImmediateCopter falcon = new ImmediateCopter(house.cloud(), key, name, new Geodetic(47.3977, 8.5456));
        record(falcon);
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, secret)) {
            fly(holder, falcon, stream);
            List<JsonNode> all = stream.heard();
            assertThat(all).hasSizeGreaterThan(10);
            all.forEach(message -> heard.put("stream " + heard.size(), message.toString()));
        }

        assertThat(heard).hasSizeGreaterThan(600);
        List<String> telling = heard.entrySet().stream()
                .filter(each -> tells(each.getKey(), each.getValue(), falcon))
                .map(Map.Entry::toString)
                .toList();
        assertThat(telling).isEmpty();
        // What is looked for is there for those who may know.
        String known = supervisor.get("/api/v1/drones/" + falcon.id()).raw().body()
                + supervisor
                        .get("/api/v1/drones/" + falcon.id() + "/commands")
                        .raw()
                        .body();
        assertThat(tells("", known, falcon)).isTrue();
        // Nothing of the next one is to be served by it.
        assertThat(supervisor
                        .send("/api/v1/warehouse/" + falcon.id(), HttpRequest.Builder::DELETE)
                        .status())
                .isLessThan(300);
    }

    private void fly(TestHttpClient holder, ImmediateCopter falcon, RecordingStreamClient stream) {
        String id = holder.post(PATH, "{\"name\":\"Survey\"," + MISSION + "}").text("id");
        keep("start", holder.post(PATH + "/" + id + "/start", "{}"));
        search("queued", holder, falcon, id);
        // It was not heard while that was asked.
        falcon.isOnGround();
        assertThat(put(supervisor, "/api/v1/warehouse/" + falcon.id(), "{}").status())
                .isEqualTo(200);
        await(holder, id, "flying");
        assertThat(supervisor.post("/api/v1/zones", ZONE.formatted(falcon.id())).status())
                .isEqualTo(201);
        search("flying", holder, falcon, id);
        ask(stream, falcon);
        falcon.reaches(0);
        falcon.reaches(1);
        ConditionWait.until(
                "a waypoint is flown",
                () -> run(holder, id).path("flown").asInt() == 1 ? Optional.of(true) : Optional.empty());
        supervisor.post("/api/v1/drones/" + falcon.id() + "/commands?wait=10", "{\"type\":\"hold\"}");
        await(holder, id, "suspended");
        assertThat(run(supervisor, id).path("detail").asString(""))
                .as("what it said")
                .isNotEmpty();
        assertThat(run(holder, id).path("detail").isNull()).isTrue();
        search("suspended", holder, falcon, id);
        falcon.isOnGround();
        keep("resume", holder.post(PATH + "/" + id + "/resume", "{}"));
        await(holder, id, "flying");
        falcon.isOnGround();
        await(holder, id, "queued");
        search("queued again", holder, falcon, id);
        keep("stop", holder.post(PATH + "/" + id + "/stop", "{}"));
        keep("remove", holder.send(PATH + "/" + id, HttpRequest.Builder::DELETE));
        stream.await(message -> message.path("type").asString().equals("virtualDroneRemoved"));
    }

    /** All that can be asked for: about that drone, by its ids, and about none. */
    private void search(String when, TestHttpClient holder, ImmediateCopter falcon, String id) {
        Map<String, String> ids = Map.of(
                "drones", falcon.id(),
                "commands", newest("/api/v1/drones/" + falcon.id() + "/commands", "commands"),
                "recordings", newest("/api/v1/recordings?drone=" + falcon.id(), "recordings"),
                "virtual-drones", id);
        for (String operation : faces.rest()) {
            if (ENDING.matcher(operation).matches()) {
                continue;
            }
            String kind = operation.replaceFirst("\\S+ /(api/v1/)?", "").split("/")[0];
            String thing = ids.getOrDefault(kind, falcon.id());
            keep(when + ": " + operation + " of it", faces.rest(holder, operation, Map.of("id", thing)));
            keep(when + ": " + operation, faces.rest(holder, operation, Map.of("id", ABSENT)));
        }
        for (String operation : faces.soap()) {
            // One more of its own would end what is looked at after fifty, and start none.
            if (ENDING.matcher(faces.restOf(operation)).matches()) {
                continue;
            }
            String kind =
                    faces.restOf(operation).replaceFirst("\\S+ /(api/v1/)?", "").split("/")[0];
            String thing = ids.getOrDefault(kind, falcon.id());
            heard.put(
                    when + ": " + operation + " of it",
                    faces.soapAsRest(holder, operation, Map.of("id", thing))
                            .raw()
                            .body());
            heard.put(
                    when + ": " + operation,
                    faces.soapAsRest(holder, operation, Map.of("id", ABSENT))
                            .raw()
                            .body());
        }
        keep(when + ": all", holder.post("/api/v1/commands", "{\"drones\":[\"all\"],\"command\":{\"type\":\"arm\"}}"));
        keep(when + ": virtual drones", holder.get(PATH));
        heard.put(when + ": virtual drones by SOAP", faces.soap(holder, "listVirtualDrones", Map.of()));
    }

    private void ask(RecordingStreamClient stream, ImmediateCopter falcon) {
        String about = "\"drone\":\"" + falcon.id() + "\"}";
        stream.send("{\"type\":\"subscribe\",\"drones\":null}");
        stream.send("{\"type\":\"command\",\"command\":{\"type\":\"land\"}," + about);
        String mine = "\",\"reason\":\"mine";
        for (String action : List.of("take", "request" + mine, "takeOver" + mine, "release")) {
            stream.send("{\"type\":\"control\",\"action\":\"" + action + "\"," + about);
        }
        stream.await(message -> message.path("type").asString().equals("error"));
    }

    private void keep(String what, TestHttpClient.Answer answer) {
        Map<String, List<String>> headers = new TreeMap<>(answer.raw().headers().map());
        // A length may be any number.
        headers.remove("content-length");
        heard.put(what, answer.raw().body() + headers);
    }

    /** Its id is an answer only where it was not in the question. */
    private boolean tells(String question, String text, ImmediateCopter falcon) {
        Stream<String> whole = Stream.of(key.address(), String.valueOf(key.port()), String.valueOf(key.systemId()));
        boolean asked = question.endsWith(" of it") || question.startsWith("stream ");
        return text.contains(name)
                || text.contains("uid-of-")
                || whole.anyMatch(word -> isIn(word, text))
                || (!asked && isIn(falcon.id(), text));
    }

    private static boolean isIn(String word, String text) {
        return Pattern.compile("(?<![\\w.-])" + Pattern.quote(word) + "(?![\\w-])")
                .matcher(text)
                .find();
    }

    private String newest(String list, String member) {
        Supplier<String> id = () ->
                supervisor.get(list).json().path(member).path(0).path("id").asString("");
        return id.get().isEmpty() ? ABSENT : id.get();
    }

    /** A flight that is recorded. */
    private void record(ImmediateCopter falcon) {
        FrameTap tap = house.recorder().open(1);
        tap.bound(new DroneId(falcon.id()));
        byte[] heartbeat = new FrameWriter(key.systemId(), 1, 2).frame(new Heartbeat(2, 3, 0x81, 4, 4, 3));
        new FrameReader().read(ByteBuffer.wrap(heartbeat), tap::received);
        ConditionWait.until(
                "it is recorded",
                () -> Optional.of(newest("/api/v1/recordings?drone=" + falcon.id(), "recordings"))
                        .filter(id -> !id.equals(ABSENT)));
    }

    private void grantVirtualDronesAlone(TestHttpClient holder) {
        String user = holder.get("/api/v1/session").text("name");
        TestHttpClient administrator = new TestHttpClient(house, house.key(Role.ADMINISTRATOR));
        assertThat(put(administrator, "/api/v1/users/" + user + "/only-granted", "{\"onlyGranted\":true}")
                        .status())
                .isEqualTo(204);
        String operations = "[\"view\",\"plan\",\"command\",\"administer\"]";
        String grant = "{\"user\":\"" + user + "\",\"virtual\":true,\"operations\":" + operations + "}";
        assertThat(administrator.post("/api/v1/grants", grant).status()).isEqualTo(201);
    }

    private static JsonNode run(TestHttpClient who, String id) {
        return who.get(PATH + "/" + id).json().path("run");
    }

    private void await(TestHttpClient who, String id, String state) {
        ConditionWait.until("it is " + state, () -> {
            TestHttpClient.Answer now = who.get(PATH + "/" + id);
            keep(state + " " + heard.size(), now);
            return Optional.of(now.json())
                    .filter(drone ->
                            drone.path("run").path("state").asString("").equals(state));
        });
    }

    private static TestHttpClient.Answer put(TestHttpClient who, String path, String body) {
        return who.send(
                path,
                request -> request.header("Content-Type", "application/json")
                        .PUT(HttpRequest.BodyPublishers.ofString(body)));
    }
}
