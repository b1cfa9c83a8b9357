package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.URLEncoder;
import java.net.http.HttpRequest;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.dronemap.core.access.Role;
import org.dronemap.ws.testserver.ExposedOperations;
import org.dronemap.ws.testserver.InjectionTexts;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.SampleBodies;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.SharedServer;
import org.dronemap.ws.testserver.SoapOperations;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/** Every text field that the running server describes takes hostile texts as texts, or refuses them in words. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class InjectionTest {
    private static final Pattern INSIDE =
            Pattern.compile("Exception|\\tat |org\\.springframework|java\\.lang|SQLSTATE|psql");
    private static final String SCHEMA = "http://www.w3.org/2001/XMLSchema";

    private final JsonMapper json = new JsonMapper();
    private TestServer house;
    private ScriptedVehicle vehicle;
    private TestHttpClient administrator;
    private String key;
    private int places;

    @BeforeAll
    void open() {
        house = SharedServer.get();
        vehicle = ScriptedVehicle.connect(house.cloud(), 20_000 + house.number());
        key = house.key(Role.ADMINISTRATOR);
        administrator = new TestHttpClient(house, key);
    }

    /** Each place is tried with an eighth of the texts, the next place with the next eighth. */
    @Test
    void takesThemInEveryAddressAndBodyOfRest() {
        assertThat(everywhere(8)).isGreaterThan(400);
        isUnharmed();
    }

    @Test
    @Tag("soak")
    void takesAllOfThemInEveryAddressAndBodyOfRest() {
        assertThat(everywhere(1)).isGreaterThan(3_000);
        isUnharmed();
    }

    private int everywhere(int shares) {
        JsonNode description = administrator.get("/api/openapi.json").json();
        int tried = 0;
        for (Map.Entry<String, JsonNode> path : description.path("paths").properties()) {
            for (Map.Entry<String, JsonNode> operation : path.getValue().properties()) {
                String method = operation.getKey().toUpperCase(Locale.ROOT);
                tried += inAddress(method, path.getKey(), operation.getValue(), shares);
                tried += inBody(method, path.getKey(), operation.getValue(), description, shares);
            }
        }
        return tried;
    }

    /** Those for the next place. */
    private List<String> texts(int shares) {
        int turn = places++ % shares;
        return IntStream.range(0, InjectionTexts.ALL.size())
                .filter(index -> index % shares == turn)
                .mapToObj(InjectionTexts.ALL::get)
                .toList();
    }

    private int inAddress(String method, String path, JsonNode operation, int shares) {
        int tried = 0;
        for (JsonNode parameter : operation.path("parameters")) {
            String name = parameter.path("name").asString();
            for (String text : texts(shares)) {
                String encoded =
                        URLEncoder.encode(text.substring(0, Math.min(3_000, text.length())), StandardCharsets.UTF_8);
                String address = parameter.path("in").asString().equals("path")
                        ? filled(path.replace("{" + name + "}", encoded))
                        : filled(path) + "?" + name + "=" + encoded;
                check(method + " " + address, ask(method, address, "{}"));
                tried++;
            }
        }
        return tried;
    }

    /** Of things that are there where there is one. */
    private String filled(String path) {
        return path.replace("/drones/{id}", "/drones/" + vehicle.id())
                .replaceAll("\\{number}", "1")
                .replaceAll("\\{\\w+}", "nosuchthing");
    }

    private int inBody(String method, String path, JsonNode operation, JsonNode description, int shares) {
        JsonNode schema = operation
                .path("requestBody")
                .path("content")
                .path("application/json")
                .path("schema");
        if (schema.isMissingNode()) {
            return 0;
        }
        JsonNode usual = SampleBodies.of(schema, description);
        int tried = 0;
        for (String at : usual.isObject() ? SampleBodies.texts(usual) : List.<String>of()) {
            for (String text : texts(shares)) {
                String body = SampleBodies.with(usual, at, text).toString();
                check(method + " " + path + " " + at, ask(method, filled(path), body));
                tried++;
            }
        }
        return tried;
    }

    private TestHttpClient.Answer ask(String method, String address, String body) {
        return administrator.send(
                address,
                request -> request.header("Content-Type", "application/json")
                        .method(method, HttpRequest.BodyPublishers.ofString(method.equals("GET") ? "" : body)));
    }

    private static void check(String what, TestHttpClient.Answer answer) {
        assertThat(answer.status()).as(what + ": " + answer.raw().body()).isLessThan(500);
        assertThat(answer.raw().headers().firstValue("Set-Cookie").orElse("")).doesNotContain("planted");
        assertThat(answer.raw().headers().firstValue("Content-Type").orElse(""))
                .as(what)
                .doesNotContain("html");
        assertThat(answer.raw().body().length()).isLessThan(200_000);
        assertThat(INSIDE.matcher(answer.raw().body()).find())
                .as(what + ": " + answer.raw().body())
                .isFalse();
    }

    @Test
    void takesThemInEveryElementOfSoap() {
        ExposedOperations faces = new ExposedOperations(house);
        int tried = 0;
        for (String operation : faces.soap()) {
            for (SoapOperations.OrganisationMember element : faces.elements(operation)) {
                if (!element.type().matches("string|")) {
                    continue;
                }
                for (String text : InjectionTexts.ALL) {
                    Map<String, String> elements = new LinkedHashMap<>();
                    elements.put(faces.elementOf(operation), vehicle.id());
                    elements.put(element.name(), text.replace("&", "&amp;").replace("<", "&lt;"));
                    String answer = faces.soap(administrator, operation, elements);
                    String what = operation + " " + element + ": " + answer;
                    assertThat(answer.contains("Response") || answer.contains(":Client</faultcode>"))
                            .as(what)
                            .isTrue();
                    assertThat(INSIDE.matcher(answer).find()).as(what).isFalse();
                    tried++;
                }
            }
        }

        assertThat(tried).isGreaterThan(200);
        isUnharmed();
    }

    private static final List<String> ABOUT_DRONES = List.of("command", "control", "steer", "letGo");

    @Test
    void takesThemInEveryMemberThatTheStreamKnows() {
        int tried = 0;
        for (String type :
                List.of("ping", "subscribe", "command", "control", "steer", "letGo", "positions", "authenticate")) {
            for (String member : members(type)) {
                for (String text : InjectionTexts.ALL) {
                    ObjectNode message = json.createObjectNode();
                    message.put("type", type);
                    if (type.equals("control")) {
                        message.put("action", "refuse");
                    }
                    if (ABOUT_DRONES.contains(type)) {
                        message.put("drone", vehicle.id());
                    }
                    message.put(member, text);
                    tried += say(message.toString());
                    ObjectNode inside = json.createObjectNode();
                    inside.put("type", "command").put("drone", vehicle.id());
                    inside.putObject("command").put("type", "setMode").put(type.equals("ping") ? "mode" : "type", text);
                    if (member.equals("command")) {
                        tried += say(inside.toString());
                    }
                }
            }
        }

        assertThat(tried).isGreaterThan(200);
        isUnharmed();
    }

    private List<String> members(String type) {
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, key)) {
            String action = type.equals("control") ? "\"action\":\"refuse\"," : "";
            stream.send("{\"type\":\"" + type + "\"," + action + "\"nosuchmember\":1}");
            JsonNode problem =
                    stream.await(message -> message.path("type").asString().equals("error"));
            List<String> members =
                    List.of(problem.path("problem").path("allowed").asString().split(", ", -1));
            assertThat(members).contains("requestId");
            return members;
        }
    }

    private @org.jspecify.annotations.Nullable RecordingStreamClient talking;

    private int say(String message) {
        if (talking == null) {
            talking = RecordingStreamClient.withKey(house, key);
        }
        talking.send(message);
        return 1;
    }

    /** Everybody is still served, nothing was planted, and no text has become anything else. */
    private void isUnharmed() {
        RecordingStreamClient stream = talking;
        if (stream != null) {
            stream.send("{\"type\":\"ping\",\"requestId\":\"last\"}");
            stream.await(message -> message.path("type").asString().equals("pong"));
            assertThat(stream.heard().stream()
                            .filter(message ->
                                    message.path("problem").path("status").asInt() >= 500)
                            .toList())
                    .isEmpty();
            stream.close();
            talking = null;
        }
        assertThat(administrator.get("/api/v1/health").text("status")).isEqualTo("up");
        assertThat(administrator.get("/api/v1/drones/" + vehicle.id()).status()).isEqualTo(200);
        assertThat(house.data().getParent().resolve("etc")).doesNotExist();
    }

    @Test
    void keepsAndShowsThemAsTheyAre() {
        for (String text : InjectionTexts.ALL) {
            ObjectNode body = json.createObjectNode().put("name", text);
            TestHttpClient.Answer renamed = ask("PATCH", "/api/v1/drones/" + vehicle.id(), body.toString());
            TestHttpClient.Answer mission = ask(
                    "POST",
                    "/api/v1/missions",
                    body.set("items", json.readTree("[{\"type\":\"takeOff\",\"altitude\":20}]"))
                            .toString());

            isTheSameOrRefused(text, renamed, "/api/v1/drones/" + vehicle.id());
            isTheSameOrRefused(text, mission, "/api/v1/missions/" + mission.text("id"));
        }
    }

    private void isTheSameOrRefused(String text, TestHttpClient.Answer changed, String address) {
        if (changed.status() < 300) {
            TestHttpClient.Answer shown = administrator.get(address);
            assertThat(shown.text("name")).isEqualTo(text.strip());
            assertThat(shown.raw().headers().firstValue("Content-Type").orElse(""))
                    .startsWith("application/json");
            assertThat(shown.raw().headers().firstValue("X-Content-Type-Options"))
                    .hasValue("nosniff");
        } else {
            assertThat(changed.status()).as(text).isBetween(400, 422);
            assertThat(changed.text("detail")).isNotEmpty();
        }
    }
}
