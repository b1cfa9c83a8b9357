package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.ws.testserver.CommandBodies;
import org.dronemap.ws.testserver.ConditionWait;
import org.dronemap.ws.testserver.OpenApiBodies;
import org.dronemap.ws.testserver.OpenApiBounds;
import org.dronemap.ws.testserver.OrganisationMember;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ObjectNode;

/** What the description says of lengths and ranges is what is refused: nothing at a bound, and all that is just beyond. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class DescribedBoundsTest {
    private static final String API = "/api/v1";
    private static final String ID = "\"id\":\"just-an-id\"";
    private static final String PLACE = "\"latitude\":47.4,\"longitude\":8.5";

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final JsonNode description =
            new TestHttpClient(tenant.server(), "").get("/api/openapi.json").json();
    private final OpenApiBounds bounds = new OpenApiBounds(description);
    private final OpenApiBodies bodies = new OpenApiBodies(description);
    private final CommandBodies commands = new CommandBodies(description);
    private TestHttpClient administrator;
    private TestHttpClient operator;
    private String drone;
    private String copter;
    private String member;
    private OrganisationMember someone;
    private String run;
    private String follow;

    /**
     * A request that is right but for what is changed of it.
     *
     * @param left a member that another example tries; empty: none
     */
    private record Example(TestHttpClient who, String method, String pattern, String path, String body, String left) {
        Example(TestHttpClient who, String method, String pattern, String path, String body) {
            this(who, method, pattern, path, body, "");
        }

        Example without(String member) {
            return new Example(who, method, pattern, path, body, member);
        }

        @Override
        public String toString() {
            return method + " " + pattern + " " + body;
        }
    }

    @BeforeAll
    void open() {
        administrator = tenant.http(Role.ADMINISTRATOR);
        operator = tenant.http(Role.OPERATOR);
        drone = tenant.vehicle().id();
        someone = tenant.member("someone", Role.VIEWER);
        member = someone.name();
        copter = copter("Kestrel");
        run = run();
        follow = follow();
    }

    private String copter(String name) {
        return tenant.copter(name, new Geodetic(47.3977, 8.5456))
                .wellHeard(tenant.server().cloud())
                .id();
    }

    private String run() {
        String flying = copter("Falcon");
        String plan = operator.post(
                        API + "/plans",
                        "{\"drones\":[\"" + flying + "\"],\"seconds\":0.1,\"waypoints\":[{\"latitude\":47.3985,"
                                + "\"longitude\":8.5456,\"altitude\":30}]}")
                .text("id");
        ConditionWait.until(
                "the plan is finished",
                () -> Optional.of(operator.get(API + "/plans/" + plan))
                        .filter(asked -> asked.text("state").equals("finished")));
        return operator.post(API + "/runs", "{\"plan\":\"" + plan + "\"}").text("id");
    }

    private String follow() {
        String flying = copter("Heron");
        TestHttpClient.Answer served = tenant.http(Role.SUPERVISOR)
                .send(
                        API + "/warehouse/" + flying,
                        request -> request.header("Content-Type", "application/json")
                                .PUT(HttpRequest.BodyPublishers.ofString("{}")));
        assertThat(served.status()).isLessThan(300);
        return operator.post(API + "/follows", "{\"latitude\":47.3980,\"longitude\":8.5456}")
                .text("id");
    }

    Stream<Example> examples() {
        List<Example> all = Stream.of(commands(), plans(), operations(), areas(), access(), names())
                .flatMap(List::stream)
                .toList();
        return Stream.concat(all.stream(), described(left(all.stream())));
    }

    /** What concerns a drone has an example of what the description says of its body. */
    private Stream<Example> described(TreeSet<String> wanted) {
        return bodies.operations().stream()
                .filter(operation -> operation.matches("\\w+ " + API + "/drones/\\{id}(/[a-z-]+)*"))
                .map(operation -> operation.split(" "))
                .map(words -> new Example(
                        administrator,
                        words[0].toLowerCase(Locale.ROOT),
                        words[1],
                        words[1].replace("{id}", drone),
                        bodies.of(words[0] + " " + words[1]).orElseThrow().toString()))
                .filter(one -> probes(one).anyMatch(probe -> wanted.contains(probe.member())));
    }

    private Stream<OpenApiBounds.Probe> probes(Example one) {
        return bounds.probes(one.method(), one.pattern(), one.body()).stream()
                .filter(probe -> !probe.field().equals(one.left()));
    }

    private TreeSet<String> left(Stream<Example> examples) {
        TreeSet<String> left = bounds.members();
        examples.flatMap(this::probes).forEach(probe -> left.remove(probe.member()));
        return left;
    }

    private Example post(String path, String body) {
        return new Example(operator, "post", API + path, API + path, body);
    }

    private Example command(String members) {
        return new Example(
                operator,
                "post",
                API + "/drones/{id}/commands",
                API + "/drones/" + drone + "/commands",
                "{" + members + "}");
    }

    private static String members(ObjectNode body) {
        String text = body.toString();
        return text.substring(1, text.length() - 1);
    }

    private List<Example> commands() {
        Stream<Example> each = commands.types().stream().sorted().map(type -> command(members(commands.bounded(type))));
        return Stream.of(
                        each,
                        Stream.of(post(
                                "/commands", "{\"drones\":[\"unlike\"],\"command\":{\"type\":\"hold\"}," + ID + "}")))
                .flatMap(all -> all)
                .toList();
    }

    /** Each has a waypoint that cannot be read, so that nothing is searched for. */
    private List<Example> plans() {
        String tasks =
                "\"tasks\":[{\"type\":\"servo\",\"output\":1,\"pulse\":1000},{\"type\":\"lookAt\",\"altitude\":10,"
                        + PLACE + "},{\"type\":\"readSensors\",\"seconds\":5}]";
        String waypoint =
                "{" + PLACE + ",\"altitude\":1000,\"altitudeReference\":\"amsl\",\"id\":\"roof\",\"holdSeconds\":1,"
                        + "\"priority\":1,\"window\":{\"opens\":1},";
        String unread = "\"waypoints\":[" + waypoint + tasks + "},{\"window\":{\"closes\":1}," + PLACE
                + ",\"altitude\":1000,\"altitudeReference\":\"amsl\"},{}]";
        return List.of(
                post(
                                "/plans",
                                "{\"drones\":[\"" + copter + "\"],\"seconds\":1,\"wind\":{\"speed\":1,\"from\":1},"
                                        + unread + "}")
                        .without("drones"),
                post("/plans", "{\"drones\":[\"unlike\"]}"),
                post("/plans", "{\"upTo\":1,\"waypoints\":[{}]}").without("waypoints"),
                post(
                                "/plans",
                                "{\"drones\":[\"" + copter
                                        + "\"],\"objective\":{\"kind\":\"weighted\",\"longestWeight\":1,\"sumWeight\":1},"
                                        + "\"waypoints\":[{}]}")
                        .without("drones"),
                post("/tours", "{\"drone\":\"" + copter + "\",\"seconds\":1,\"waypoints\":[{}]}"));
    }

    private List<Example> operations() {
        String runs = "/runs/" + run + "/waypoints";
        String now = Instant.now().toString();
        String phone = "\"speed\":1,\"course\":1,\"accuracy\":1,\"id\":1,\"at\":\"" + now + "\"," + PLACE;
        String positions = "{\"sent\":\"" + now + "\",\"roundTrip\":1,\"positions\":[{" + phone + "}]}";
        return List.of(
                post("/runs", "{\"plan\":\"nosuchplan\",\"name\":\"roofs\",\"searchSeconds\":1}"),
                new Example(operator, "post", API + "/runs/{id}/waypoints", API + runs, "{\"waypoints\":[{}]}"),
                new Example(
                        operator,
                        "patch",
                        API + "/runs/{id}/waypoints/{waypoint}",
                        API + runs + "/1",
                        "{\"altitude\":1000,\"altitudeReference\":\"amsl\"," + PLACE + "}"),
                post("/follows", "{\"name\":\"me\",\"minutes\":1,\"speed\":1,\"patience\":10," + PLACE + "}"),
                post(
                        "/follows",
                        "{\"place\":{\"side\":\"fixed\",\"bearing\":1,\"distance\":1,\"height\":5}," + PLACE + "}"),
                post("/recoveries/preview", "{\"manner\":\"return\",\"lowest\":5,\"ceiling\":500}"),
                post("/recoveries", "{\"manner\":\"return\",\"lowest\":5,\"ceiling\":500}"),
                post("/dispatches", "{\"height\":5,\"minutes\":1," + PLACE + "}"),
                post("/follows", "{\"place\":{\"side\":\"orbit\",\"turn\":1}," + PLACE + "}"),
                new Example(
                        operator,
                        "post",
                        API + "/follows/{id}/positions",
                        API + "/follows/" + follow + "/positions",
                        positions));
    }

    private List<Example> areas() {
        String point = "\"type\":\"Point\",\"coordinates\":[10,10]";
        String zone = "{\"type\":\"Feature\",\"geometry\":{" + point + "},\"properties\":{\"radius\":5,\"drone\":\""
                + drone + "\",";
        String fence = "{\"zones\":[{\"type\":\"circle\",\"inside\":false,\"radius\":5,\"center\":{" + PLACE
                + "}},{\"type\":\"polygon\",\"inside\":false,\"corners\":[{" + PLACE
                + "},{\"latitude\":47.5,\"longitude\":8.5},{\"latitude\":47.5,\"longitude\":8.6}]}],\"returnPoint\":{"
                + PLACE + "}}";
        return List.of(
                as(administrator, "/zones", zone + "\"name\":\"Park\",\"floor\":10}}"),
                as(administrator, "/zones", zone + "\"name\":\"Lake\",\"ceiling\":10}}"),
                post("/access-keys", "{\"label\":\"a\",\"days\":1,\"drones\":[\"unlike\"],\"floor\":10}"),
                post("/access-keys", "{\"label\":\"b\",\"ceiling\":10,\"area\":{\"radius\":5," + point + "}}"),
                new Example(operator, "put", API + "/drones/{id}/fence", API + "/drones/" + drone + "/fence", fence),
                new Example(
                        operator,
                        "put",
                        API + "/drones/{id}/rally-points",
                        API + "/drones/" + drone + "/rally-points",
                        "{\"points\":[{\"altitude\":10," + PLACE + "}]}"),
                post(
                        "/virtual-drones",
                        "{\"name\":\"a\",\"upTo\":1,\"needs\":{\"enduranceMinutes\":1,\"area\":{\"radius\":5," + PLACE
                                + "}}}"));
    }

    private Example as(TestHttpClient who, String path, String body) {
        return new Example(who, "post", API + path, API + path, body);
    }

    private List<Example> access() {
        TestHttpClient server =
                new TestHttpClient(tenant.server(), tenant.server().key(Role.ADMINISTRATOR));
        return List.of(
                post("/outlet/ports", "{\"address\":\"nowhere\",\"hours\":1}"),
                new Example(
                        someone.http(),
                        "put",
                        API + "/outlet/passphrase",
                        API + "/outlet/passphrase",
                        "{\"passphrase\":\"just-a-passphrase\"}"),
                new Example(
                        someone.http(),
                        "post",
                        API + "/session/password",
                        API + "/session/password",
                        "{\"current\":\"another password\",\"next\":\"a-long-password\"}"),
                post(
                        "/registrations",
                        "{\"name\":\"" + tenant.unique("guest") + "\",\"password\":\"a-long-password\"}"),
                new Example(
                        operator,
                        "post",
                        API + "/drones/{id}/control/request",
                        API + "/drones/" + drone + "/control/request",
                        "{\"reason\":\"a\"}"),
                as(server, "/dtls-keys", "{\"label\":\"a\"}"),
                new Example(
                        server,
                        "post",
                        API + "/waiting/{id}/enrol",
                        API + "/waiting/nobody/enrol",
                        "{\"name\":\"a\"}"));
    }

    private List<Example> names() {
        TestHttpClient server =
                new TestHttpClient(tenant.server(), tenant.server().key(Role.ADMINISTRATOR));
        return List.of(
                post(
                        "/missions",
                        "{\"name\":\"a\",\"items\":[{\"type\":\"waypoint\",\"altitude\":10," + PLACE
                                + "},{\"type\":\"lookAt\",\"altitude\":10," + PLACE + "},{\"type\":\"land\"," + PLACE
                                + "}]}"),
                as(administrator, "/groups", "{\"name\":\"a\",\"members\":[\"" + member + "\"]}"),
                as(administrator, "/fleets", "{\"name\":\"a\",\"drones\":[\"" + drone + "\"]}"),
                as(administrator, "/invitations", "{\"label\":\"a\",\"role\":\"viewer\",\"days\":1}"),
                as(
                        administrator,
                        "/users",
                        "{\"name\":\"" + tenant.unique("new")
                                + "\",\"role\":\"viewer\",\"password\":\"a-long-password\"}"),
                new Example(
                        operator,
                        "patch",
                        API + "/flights/{id}",
                        API + "/flights/nosuchflight",
                        "{\"notes\":\"windy\"}"),
                as(server, "/robot-keys", "{\"label\":\"a\",\"systemId\":1,\"owner\":\"b\"}"),
                new Example(
                        server,
                        "patch",
                        API + "/organisations/{id}",
                        API + "/organisations/" + tenant.organisation().value(),
                        "{\"name\":\"a\"}"),
                new Example(
                        administrator, "patch", API + "/drones/{id}", API + "/drones/" + drone, "{\"name\":\"a\"}"));
    }

    private static TestHttpClient.Answer answer(Example example, String body) {
        return example.who()
                .send(
                        example.path(),
                        request -> request.header("Content-Type", "application/json")
                                .method(
                                        example.method().toUpperCase(Locale.ROOT),
                                        HttpRequest.BodyPublishers.ofString(body)));
    }

    @ParameterizedTest
    @MethodSource("examples")
    void areThoseThatAreKeptTo(Example example) {
        List<OpenApiBounds.Probe> probes = bounds.probes(example.method(), example.pattern(), example.body());

        assertThat(probes).isNotEmpty();
        for (OpenApiBounds.Probe probe : probes) {
            if (probe.field().equals(example.left())) {
                continue;
            }
            TestHttpClient.Answer answer = answer(example, probe.body());
            boolean refused = answer.status() == 422 && answer.text("field").equals(probe.field());
            assertThat(refused)
                    .as(
                            "%s with %.200s: %d %.300s",
                            probe.field(),
                            probe.body(),
                            answer.status(),
                            answer.raw().body())
                    .isEqualTo(!probe.inside());
        }
    }

    @Test
    void areAllTried() {
        assertThat(left(examples())).isEmpty();
    }
}
