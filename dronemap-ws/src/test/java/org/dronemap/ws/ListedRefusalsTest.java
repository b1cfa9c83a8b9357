package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import org.dronemap.core.access.Grant;
import org.dronemap.core.access.OrganisationDirectory;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.link.RobotKey;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.ws.budget.BudgetRates;
import org.dronemap.ws.limit.ClientLimits;
import org.dronemap.ws.robotkey.RobotKeyFixture;
import org.dronemap.ws.settings.ServerSettings;
import org.dronemap.ws.testserver.ConditionWait;
import org.dronemap.ws.testserver.DeclaredStatuses;
import org.dronemap.ws.testserver.RawClient;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;

/**
 * Each operation of REST refuses, as it lists, what is refused in the same way everywhere: broken, slow and long requests, one
 * of a crowd, what cannot be stored.
 */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class ListedRefusalsTest {
    private static final int CROWD = 20;
    /** Keys of robots, and grants. */
    private static final int MOST_OF_A_SERVER = 2_000;

    private static final Duration PATIENCE = Duration.ofSeconds(1);
    private static final String JSON = "application/json";
    private static final long TOO_LONG = 600_000_000;

    private TestServer house;
    private String key;
    private List<Listed> operations;

    /** An operation as the description has it, on things that are not there. */
    private record Listed(String method, String path, JsonNode description) {
        boolean lists(int status) {
            return description.path("responses").has(String.valueOf(status));
        }

        /** Empty: it takes no body. */
        Optional<String> body() {
            return description.path("requestBody").path("content").propertyNames().stream()
                    .findFirst();
        }

        boolean takesBody() {
            return body().isPresent();
        }

        boolean takesQuery() {
            return description
                    .path("parameters")
                    .valueStream()
                    .anyMatch(parameter -> parameter.path("in").asString().equals("query"));
        }

        String address() {
            return path.replace("{number}", "1").replaceAll("\\{\\w+}", "nosuchthing");
        }

        @Override
        public String toString() {
            return method + " " + path;
        }
    }

    @BeforeAll
    void open(@TempDir Path data) {
        ServerSettings.Protection protection =
                new ServerSettings.Protection(new ClientLimits(1_000, CROWD, PATIENCE), BudgetRates.UNBOUNDED);
        house = new TestServer(data, TestServer.Options.protectedBy(protection));
        key = house.key(Role.ADMINISTRATOR);
        List<Listed> all = new ArrayList<>();
        new TestHttpClient(house, "")
                .get("/api/openapi.json")
                .json()
                .path("paths")
                .forEachEntry((path, methods) -> {
                    methods.forEachEntry((method, description) ->
                            all.add(new Listed(method.toUpperCase(Locale.ROOT), path, description)));
                });
        operations = all;
    }

    @AfterAll
    void close() {
        house.close();
    }

    /** The status of each that lists that one, and is of those, is that one. */
    private void each(int status, Predicate<Listed> which, Function<Listed, String> first) {
        List<Listed> tried = operations.stream()
                .filter(one -> one.lists(status))
                .filter(which)
                .toList();
        assertThat(tried).isNotEmpty();
        assertThat(tried).allSatisfy(one -> {
            assertThat(first.apply(one)).as(one.toString()).startsWith("HTTP/1.1 " + status);
            DeclaredStatuses.check(one.method(), one.address(), status);
        });
    }

    /** The first line of the answer. */
    private String answer(String method, String address, String headers, String body) {
        try (RawClient client = new RawClient(house.httpPort())) {
            client.say(head(method, address, headers) + body);
            return client.hearLine();
        }
    }

    private static String head(String method, String address, String headers) {
        return method + " " + address + " HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n" + headers + "\r\n";
    }

    private String signed(String type, int length) {
        return "Authorization: Bearer " + key + "\r\nContent-Type: " + type + "\r\nContent-Length: " + length + "\r\n";
    }

    @Test
    void anAddressThatIsNotPlainIsRefused() {
        each(400, one -> one.path().contains("{"), one -> answer(one.method(), one.address() + ";a", "", ""));
    }

    @Test
    void aBodyThatIsNotJsonIsRefused() {
        each(
                400,
                one -> one.body().filter(JSON::equals).isPresent(),
                one -> answer(one.method(), one.address(), signed(JSON, 1), "{"));
    }

    @Test
    void aBrokenQueryIsRefused() {
        each(
                400,
                Listed::takesQuery,
                one -> answer(
                        one.method(),
                        one.address() + "?a=%zz",
                        signed(one.body().orElse(JSON), 0),
                        ""));
    }

    @Test
    void aBodyOfAnotherKindIsRefused() {
        each(
                415,
                Listed::takesBody,
                one -> answer(one.method(), one.address(), signed("application/x-www-form-urlencoded", 3), "%zz"));
    }

    @Test
    void aBodyThatIsTooLongIsRefusedBeforeItIsSent() {
        each(
                413,
                Listed::takesBody,
                one -> answer(one.method(), one.address(), "Content-Length: " + TOO_LONG + "\r\n", ""));
    }

    /** All at once, each from an address of its own: they have to wait until the server's patience is over. */
    @Test
    void aBodyThatDoesNotComeIsRefused() {
        Map<Listed, RawClient> slow = new LinkedHashMap<>();
        try {
            operations.stream()
                    .filter(Listed::takesBody)
                    .forEach(one -> slow.put(one, slow(one, "127.2.0." + (slow.size() + 1))));
            each(408, slow::containsKey, one -> slow.get(one).hearLine());
        } finally {
            slow.values().forEach(RawClient::close);
        }
    }

    private RawClient slow(Listed one, String from) {
        RawClient client = new RawClient(house.httpPort(), from);
        client.say(head(one.method(), one.address(), signed(one.body().orElse(JSON), 100)));
        return client;
    }

    /** As often as it takes: those who make the crowd are sent away when the server's patience is over. */
    @Test
    void oneOfACrowdIsRefused() {
        Listed taker = operations.stream().filter(Listed::takesBody).findFirst().orElseThrow();
        List<Listed> left = new ArrayList<>(operations);
        assertThat(left).allMatch(one -> one.lists(429));
        ConditionWait.until("each has refused one of a crowd", () -> {
            List<RawClient> crowd = IntStream.range(0, CROWD)
                    .mapToObj(number -> slow(taker, "127.0.0.1"))
                    .toList();
            try {
                left.removeIf(one -> isCrowded(one.method(), one.address()));
            } finally {
                crowd.forEach(RawClient::close);
            }
            return Optional.of(left).filter(List::isEmpty);
        });
    }

    private boolean isCrowded(String method, String address) {
        return answer(method, address, "Content-Length: 0\r\n", "").startsWith("HTTP/1.1 429");
    }

    private boolean needsKey(Listed one) {
        return answer(one.method(), one.address(), "Content-Length: 0\r\n", "").startsWith("HTTP/1.1 401");
    }

    /** Before anything else, when it looks for who has the key. */
    @Test
    void saysThatTheStoreIsAway() {
        house.stores().off();
        house.historyStores().off();
        try {
            each(
                    503,
                    this::needsKey,
                    one -> one.takesBody()
                            ? answer(
                                    one.method(),
                                    one.address(),
                                    signed(one.body().orElse(JSON), 2),
                                    "{}")
                            : answer(one.method(), one.address(), signed(JSON, 0), ""));
        } finally {
            house.stores().on();
            house.historyStores().on();
        }
    }

    /** One after the other until there is no room; each has an id of its own in the body. */
    private void isFull(String path, int most, String body) {
        isFull(path, most, JSON, body);
    }

    private void isFull(String path, int most, String type, String body) {
        int made = 0;
        TestHttpClient.Answer last = post(path, type, body);
        while (last.status() < 300 && made <= most) {
            made++;
            last = post(path, type, body);
        }
        assertThat(last.status()).as(path + ": " + last.raw().body()).isEqualTo(409);
        assertThat(last.text("code")).isEqualTo("limit-reached");
    }

    private TestHttpClient.Answer post(String path, String type, String body) {
        String text = body.formatted(house.number());
        return new TestHttpClient(house, key)
                .send(
                        "/api/v1/" + path,
                        request ->
                                request.header("Content-Type", type).POST(HttpRequest.BodyPublishers.ofString(text)));
    }

    @Test
    void saysThatThereIsNoRoomForMore() {
        String labelled = "{\"label\":\"a%d\"}";
        String named = "{\"name\":\"a%d\"}";
        String zone = "{\"type\":\"Feature\",\"geometry\":{\"type\":\"Point\",\"coordinates\":[10,60]},"
                + "\"properties\":{\"name\":\"a%d\",\"kind\":\"exclusion\",\"radius\":50}}";
        isFull("access-keys", 200, labelled);
        isFull("groups", 500, named);
        isFull("fleets", 500, named);
        isFull("invitations", 500, "{\"label\":\"a%d\",\"role\":\"viewer\"}");
        isFull("zones", 500, zone);
        isFull("zones/import", 500, zone);
        isFull("virtual-drones", 50, named);
        giveRobotsKeys();
        isFull("robot-keys", 1, "{\"label\":\"a%d\",\"systemId\":7}");
        String grant = "{\"user\":\""
                + house.member(OrganisationId.HOME, "ann", Role.VIEWER).name()
                + "\",\"all\":true,\"operations\":[\"view\"]}";
        assertThat(post("grants", JSON, grant).status()).isEqualTo(201);
        copyTheGrant();
        isFull("grants", 1, grant);
        isFull("outlet/ports", 10, "{\"address\":\"192.0.2.7\"}");
        isFull("replays?name=a.tlog", 100, "application/octet-stream", "a recording");
    }

    /** As many as there may be, at once. */
    private void giveRobotsKeys() {
        for (int number = 0; number < MOST_OF_A_SERVER; number++) {
            RobotKeyFixture.keep(
                    house.robotKeys(),
                    new RobotKey(
                            new DroneId("robot-" + number),
                            "turtle",
                            7,
                            null,
                            Integer.toHexString(number),
                            "ann",
                            "an account",
                            Instant.EPOCH));
        }
    }

    /** Until there are as many as there may be. */
    private void copyTheGrant() {
        OrganisationDirectory now = house.grants().directory();
        Grant one = now.grants().get(0);
        List<Grant> copies = IntStream.range(0, MOST_OF_A_SERVER)
                .mapToObj(number -> new Grant(
                        "grant-" + number,
                        one.organisation(),
                        one.subject(),
                        one.object(),
                        one.permissions(),
                        one.from(),
                        one.until(),
                        one.madeBy(),
                        one.madeAt()))
                .toList();
        house.grants()
                .replace(new OrganisationDirectory(
                        now.organisations(),
                        now.owners(),
                        now.groups(),
                        now.fleets(),
                        copies,
                        now.gifts(),
                        now.onlyGranted()));
    }
}
