package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.classic.spi.ThrowableProxyUtil;
import ch.qos.logback.core.read.ListAppender;
import java.net.http.HttpRequest;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronemap.core.access.Role;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;
import org.slf4j.LoggerFactory;
import tools.jackson.databind.JsonNode;

/** Every kind of secret is put in and used, rightly and wrongly; then no answer, message or log line has any of them. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class CanaryTest {
    private static final String PASSWORD = "canary-password-2f9c81";
    private static final String NEXT_PASSWORD = "canary-next-password-77ab";
    private static final String WRONG_PASSWORD = "canary-wrong-password-c0ffee";
    private static final String LINK_KEY = "c0ffee00".repeat(8);

    private final Map<String, String> canaries = new LinkedHashMap<>();
    private final List<String> heard = new ArrayList<>();
    private final ListAppender<ILoggingEvent> log = new ListAppender<>();
    private final Logger root = (Logger) LoggerFactory.getLogger(org.slf4j.Logger.ROOT_LOGGER_NAME);
    private final Logger ours = (Logger) LoggerFactory.getLogger("org.dronemap");
    private TestServer house;
    private ScriptedVehicle vehicle;
    private TestHttpClient administrator;
    private TestHttpClient nobody;

    @BeforeAll
    void open(@TempDir Path data) {
        listenToTheLog();
        house = new TestServer(data, false);
        // A server that starts sets up its log anew and sends listeners away.
        listenToTheLog();
        vehicle = ScriptedVehicle.connect(house.cloud(), 15_703);
        String key = house.key(Role.ADMINISTRATOR);
        canaries.put("an access key", key);
        administrator = new TestHttpClient(house, key);
        nobody = new TestHttpClient(house, "");
    }

    private void listenToTheLog() {
        log.start();
        if (!root.isAttached(log)) {
            root.addAppender(log);
        }
        ours.setLevel(Level.DEBUG);
    }

    @AfterAll
    void close() {
        house.close();
        root.detachAppender(log);
        ours.setLevel(Level.INFO);
    }

    @Test
    void noAnswerMessageOrLogLineShowsASecret() throws Exception {
        putIn();
        useWrongly();
        lookAtEverything();
        listen();

        house.close();
        log.list.forEach(event -> {
            heard.add("log: " + event.getFormattedMessage());
            if (event.getThrowableProxy() != null) {
                heard.add("log: " + ThrowableProxyUtil.asString(event.getThrowableProxy()));
            }
        });
        assertThat(canaries).hasSizeGreaterThanOrEqualTo(9);
        assertThat(heard).hasSizeGreaterThan(100);
        assertThat(heard.stream().filter(text -> text.startsWith("log: ") && text.contains(" 401 ")))
                .as("what the log says of requests with wrong proofs")
                .hasSizeGreaterThan(20);
        canaries.forEach((what, secret) -> assertThat(
                        heard.stream().filter(text -> text.contains(secret)).toList())
                .as(what)
                .isEmpty());
    }

    /** What is shown once is taken from its one answer, and looked for everywhere else. */
    private void putIn() throws Exception {
        canaries.put(
                "the first password",
                Files.readString(house.data().resolve("first-password.txt"))
                        .strip()
                        .split(" ", 2)[1]);
        canaries.put(
                "the local key",
                Files.readString(house.data().resolve("local-key")).strip());
        canaries.put("a password", PASSWORD);
        canaries.put("a wrong password", WRONG_PASSWORD);
        canaries.put("a new password", NEXT_PASSWORD);
        canaries.put("the key of a vehicle", LINK_KEY);
        keep(administrator.post(
                "/api/v1/users", "{\"name\":\"carol\",\"role\":\"operator\",\"password\":\"" + PASSWORD + "\"}"));
        TestHttpClient.Answer session =
                nobody.post("/api/v1/session", "{\"name\":\"carol\",\"password\":\"" + PASSWORD + "\"}");
        heard.add(session.raw().body());
        String cookie =
                session.raw().headers().firstValue("Set-Cookie").orElseThrow().split(";", 2)[0];
        canaries.put("a session", cookie.split("=", 2)[1]);
        keep(nobody.send(
                "/api/v1/session", request -> request.header("Cookie", cookie).GET()));
        keep(nobody.send(
                "/api/v1/session/password",
                request -> request.header("Cookie", cookie)
                        .header("X-Dronemap", "1")
                        .header("Content-Type", "application/json")
                        .POST(HttpRequest.BodyPublishers.ofString(
                                "{\"current\":\"" + PASSWORD + "\",\"next\":\"" + NEXT_PASSWORD + "\"}"))));
        canaries.put("another key", once("/api/v1/access-keys", "{\"label\":\"a key\",\"role\":\"viewer\"}", "key"));
        canaries.put("the key of a DTLS link", once("/api/v1/dtls-keys", "{\"label\":\"copter\"}", "secret"));
        canaries.put("a ticket of the stream", once("/api/v1/stream-tickets", "", "ticket"));
        canaries.put("an invitation", once("/api/v1/invitations", "{\"label\":\"dora\",\"role\":\"viewer\"}", "code"));
        administrator.post("/api/v1/drones/" + vehicle.id() + "/link-key", "{\"key\":\"" + LINK_KEY + "\"}");
    }

    private String once(String path, String body, String member) {
        TestHttpClient.Answer answer = administrator.post(path, body);
        String secret = answer.text(member);
        assertThat(secret).as(path + ": " + answer.raw().body().length()).hasSizeGreaterThan(15);
        return secret;
    }

    private void keep(TestHttpClient.Answer answer) {
        heard.add(answer.status() + " " + answer.raw().headers().map() + " "
                + answer.raw().body());
    }

    /** Mistakes are where secrets come out. */
    private void useWrongly() {
        for (String secret : List.copyOf(canaries.values())) {
            keep(nobody.post("/api/v1/session", "{\"name\":\"carol\",\"password\":\"" + secret + "x\"}"));
            keep(nobody.post("/api/v1/session", "{\"name\":\"carol\",\"password\":" + secret + "}"));
            keep(nobody.post("/api/v1/session", "{\"name\":\"carol\",\"password\":\"" + secret));
            keep(nobody.post("/api/v1/session", "{\"name\":\"carol\",\"password\":{\"a\":\"" + secret + "\"}}"));
            keep(nobody.post(
                    "/api/v1/registrations",
                    "{\"name\":\"c\",\"password\":\"" + secret + "\",\"invitation\":\"" + secret + "x\"}"));
            keep(new TestHttpClient(house, secret + "x").get("/api/v1/drones"));
            keep(nobody.send(
                    "/api/v1/drones",
                    request -> request.header("Cookie", "dronemap-session=" + secret + "x")
                            .GET()));
            keep(nobody.send("/api/v1/drones?ticket=" + secret.replace(' ', '-'), HttpRequest.Builder::GET));
            keep(administrator.post("/api/v1/drones/" + vehicle.id() + "/link-key", "{\"key\":\"" + secret + "zz\"}"));
        }
        // These wait for the server to close: some of each kind are enough.
        for (String secret : List.copyOf(canaries.values()).subList(0, 3)) {
            keep(soap("<accessKey xmlns=\"http://cloud.dronemap.org/wsdl\">" + secret + "x</accessKey>"));
            try (RecordingStreamClient stream =
                    RecordingStreamClient.with(house, "?ticket=" + secret + "x", Map.of())) {
                heard.add(stream.awaitClose());
                stream.heard().forEach(message -> heard.add(message.toString()));
            }
            try (RecordingStreamClient stream = RecordingStreamClient.with(house, "", Map.of())) {
                stream.send("{\"type\":\"authenticate\",\"key\":\"" + secret + "x\"}");
                heard.add(stream.awaitClose());
                stream.heard().forEach(message -> heard.add(message.toString()));
            }
        }
    }

    private TestHttpClient.Answer soap(String header) {
        return nobody.send(
                "/services/MAVLinkControllerService",
                request -> request.header("Content-Type", "text/xml")
                        .POST(HttpRequest.BodyPublishers.ofString(
                                "<s:Envelope xmlns:s=\"http://schemas.xmlsoap.org/soap/envelope/\"><s:Header>" + header
                                        + "</s:Header><s:Body><w:getDronesList xmlns:w=\"http://cloud.dronemap.org/wsdl\"/>"
                                        + "</s:Body></s:Envelope>")));
    }

    private void lookAtEverything() {
        JsonNode description = administrator.get("/api/openapi.json").json();
        description.path("paths").properties().forEach(path -> {
            if (path.getValue().has("get")) {
                keep(administrator.get(path.getKey()
                        .replace("/drones/{id}", "/drones/" + vehicle.id())
                        .replaceAll("\\{number}", "1")
                        .replaceAll("\\{\\w+}", "carol")));
            }
        });
        keep(administrator.get("/metrics"));
        keep(administrator.post("/api/v1/backup", ""));
        keep(administrator.send("/api/v1/users/carol/password", request -> request.DELETE()));
    }

    private void listen() {
        try (RecordingStreamClient stream = RecordingStreamClient.withKey(house, canaries.get("an access key"))) {
            stream.await(message -> message.path("type").asString().equals("drones"));
            stream.send("{\"type\":\"nosuchtype\"}");
            stream.await(message -> message.path("type").asString().equals("error"));
            stream.heard().forEach(message -> heard.add(message.toString()));
        }
    }
}
