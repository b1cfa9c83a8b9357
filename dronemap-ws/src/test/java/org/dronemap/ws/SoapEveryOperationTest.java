package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.net.http.HttpRequest;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.dronemap.core.access.Role;
import org.dronemap.ws.testserver.ExposedOperations;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.SoapClient;
import org.dronemap.ws.testserver.SoapOperations;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.JsonNode;

/** SOAP has each operation of REST once, in both versions, and says what REST says. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class SoapEveryOperationTest {
    private static final String SOAP_11 = "http://schemas.xmlsoap.org/soap/envelope/";
    private static final String SOAP_12 = "http://www.w3.org/2003/05/soap-envelope";
    private static final String COMMANDS = "POST /api/v1/drones/{id}/commands";
    private static final Map<String, String> TYPE_OF = Map.of("takeoff", "takeOff", "goto", "goTo");

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestServer house = tenant.server();
    private final ExposedOperations faces = new ExposedOperations(house);
    private final SoapOperations operations = new SoapOperations(house);
    private String key;
    private TestHttpClient administrator;
    private SoapClient soap;
    private JsonNode description;

    @BeforeAll
    void open() {
        key = tenant.key(Role.ADMINISTRATOR);
        administrator = new TestHttpClient(house, key);
        soap = SoapClient.withKey(house, key);
        description = administrator.get("/api/openapi.json").json();
    }

    @Test
    void hasEachOperationOfRestInOneServiceAndNoOther() {
        assertThat(operations.names()).containsExactlyInAnyOrderElementsOf(operations.namesByRest());
        // The follower has two names.
        assertThat(operations.doubled())
                .isNotEmpty()
                .allMatch(name -> operations.restOf(name).contains("/follows"));
        assertThat(operations.services()).hasSizeGreaterThan(5);
    }

    /** Whatever is left out is of a browser alone, and says why. */
    @Test
    void saysOfEachOperationThatItDoesNotHaveWhy() {
        Map<String, String> without = new TreeMap<>();
        description
                .path("paths")
                .forEach(path -> path.forEach(operation -> {
                    if (operation.has("x-without-soap")) {
                        without.put(
                                operation.path("operationId").asString(),
                                operation.path("x-without-soap").asString());
                    }
                }));
        assertThat(without).containsOnlyKeys("signIn", "signOut", "startSignInElsewhere", "finishSignInElsewhere");
        assertThat(without.values()).allMatch(why -> why.endsWith("."));
    }

    @Test
    void turnsAStrangerAwayAsRestDoes() {
        TestHttpClient nobody = new TestHttpClient(house, "");
        List<String> wrong = new ArrayList<>();
        for (String operation : faces.soap()) {
            String bySoap = faces.soapAsRest(nobody, operation, Map.of()).raw().body();
            TestHttpClient.Answer byRest = faces.rest(nobody, faces.restOf(operation), Map.of());
            boolean same = byRest.status() < 400
                    ? bySoap.contains(operation + "Response")
                    : bySoap.contains("<status>" + byRest.status() + "</status>")
                            && bySoap.contains("<code>" + byRest.text("code") + "</code>");
            if (!same) {
                wrong.add(operation + ": " + bySoap + " / " + byRest.raw().body());
            }
        }
        assertThat(wrong).isEmpty();
    }

    @Test
    void saysOfAnElementThatNobodyKnowsWhichThereAreAsRestDoesOfMembers() {
        List<String> wrong = new ArrayList<>();
        int compared = 0;
        for (String operation : faces.soap()) {
            StringBuilder elements = new StringBuilder("<nosuchmember>x</nosuchmember>");
            String rest = faces.restOf(operation);
            long variables = rest.chars().filter(letter -> letter == '{').count();
            faces.elements(operation).stream()
                    .limit(variables)
                    .forEach(element -> elements.append("<")
                            .append(element.name())
                            .append(">1</")
                            .append(element.name())
                            .append(">"));
            TestHttpClient.Answer eleven = version(SOAP_11, operation, elements.toString());
            TestHttpClient.Answer twelve = version(SOAP_12, operation, elements.toString());
            String sentence = sentence(eleven);
            if (!eleven.raw().body().contains("<code>member-unknown</code>")
                    || !sentence.equals(
                            "There is no element \"nosuchmember\" here; there are: " + known(operation) + ".")) {
                wrong.add(operation + ": " + eleven.raw().body());
            }
            if (hasBody(rest)) {
                TestHttpClient.Answer byRest = byRest(rest, operation);
                compared++;
                String code = byRest.text("code");
                boolean sameCode = eleven.raw().body().contains("<code>" + code + "</code>");
                if (byRest.status() != 422 || !code.equals("member-unknown") || !sameCode) {
                    wrong.add(operation + ": " + code + ", " + sentence);
                }
            }
            if (!sentence(twelve).equals(sentence)
                    || !eleven.raw().body().contains(SOAP_11)
                    || !twelve.raw().body().contains(SOAP_12)) {
                wrong.add(operation + " by 1.2: " + twelve.raw().body());
            }
        }
        assertThat(wrong).isEmpty();
        assertThat(compared).isGreaterThan(60);
    }

    private String known(String operation) {
        String names = faces.elements(operation).stream()
                .map(element -> element.name())
                .collect(Collectors.joining(", "));
        return names.isEmpty() ? "none" : names;
    }

    private boolean hasBody(String rest) {
        String[] words = rest.split(" ");
        return description
                .path("paths")
                .path(words[1])
                .path(words[0].toLowerCase(java.util.Locale.ROOT))
                .path("requestBody")
                .path("content")
                .path("application/json")
                .path("schema")
                .has("$ref");
    }

    private TestHttpClient.Answer byRest(String rest, String operation) {
        String[] words = rest.split(" ");
        String type = rest.equals(COMMANDS) ? "\"type\":\"" + TYPE_OF.getOrDefault(operation, operation) + "\"," : "";
        return administrator.send(
                words[1].replaceAll("\\{\\w+}", "1"),
                request -> request.header("Content-Type", "application/json")
                        .method(words[0], HttpRequest.BodyPublishers.ofString("{" + type + "\"nosuchmember\":\"x\"}")));
    }

    private TestHttpClient.Answer version(String version, String operation, String elements) {
        String envelope = SoapClient.envelope("", "<w:" + operation + ">" + elements + "</w:" + operation + ">")
                .replace(SOAP_11, version);
        return administrator.send(
                operations.get(operation).service(),
                request -> request.header("Content-Type", version.equals(SOAP_11) ? "text/xml" : "application/soap+xml")
                        .POST(HttpRequest.BodyPublishers.ofString(envelope)));
    }

    private static String sentence(TestHttpClient.Answer answer) {
        return answer.raw()
                .body()
                .replaceFirst("(?s).*<status>\\d+</status><detail>(.*?)</detail>.*", "$1")
                .replace("&lt;", "<")
                .replace("&gt;", ">")
                .replace("&amp;", "&");
    }

    /** A key of no drone at all is another thing than one of all drones. */
    @Test
    void tellsListsThatAreAbsentEmptyAndNilFromEachOtherAsRestDoes() {
        ScriptedVehicle vehicle = tenant.vehicle();
        String label = "\"label\":\"a key\"";
        for (String body : List.of("{" + label + "}", "{" + label + ",\"drones\":null}")) {
            TestHttpClient.Answer made = administrator.post("/api/v1/access-keys", body);
            assertThat(made.json().path("drones").isNull()).as(body).isTrue();
        }
        TestHttpClient.Answer none = administrator.post("/api/v1/access-keys", "{" + label + ",\"drones\":[]}");

        assertThat(soap.call("makeAccessKey", "label", "a key").texts("drones")).isEmpty();
        assertThat(soap.call("makeAccessKey", "label", "a key", "drones", SoapClient.NIL)
                        .texts("drones"))
                .isEmpty();
        assertThat(soap.call("makeAccessKey", "label", "a key", "drones", List.of(vehicle.id()))
                        .texts("drones.item"))
                .containsExactly(vehicle.id());
        asRest(none, "drones", "makeAccessKey", "label", "a key", "drones", List.of());
    }

    @Test
    void grantsNoDroneWhereTheListIsEmpty() {
        String name = tenant.member("ann", Role.OPERATOR).name();
        String grant = "\"user\":\"" + name + "\",\"operations\":[\"view\"]";
        for (String drones : List.of("", ",\"drones\":[]", ",\"drones\":null")) {
            TestHttpClient.Answer byRest = administrator.post("/api/v1/grants", "{" + grant + drones + "}");
            Object value = drones.isEmpty() ? null : drones.endsWith("null") ? SoapClient.NIL : List.of();
            asRest(byRest, "drones", "addGrant", "user", name, "operations", List.of("view"), "drones", value);
        }
    }

    /** The same sentence, or the same list. */
    private void asRest(TestHttpClient.Answer byRest, String list, String operation, Object... namesAndValues) {
        if (byRest.status() >= 400) {
            SoapClient.Refused refused =
                    catchThrowableOfType(SoapClient.Refused.class, () -> soap.call(operation, namesAndValues));
            assertThat(refused).hasMessage(byRest.text("detail"));
            assertThat(refused.member("code")).isEqualTo(byRest.text("code"));
        } else {
            SoapClient.Answer bySoap = soap.call(operation, namesAndValues);
            assertThat(bySoap.texts(list)).hasSize(byRest.json().path(list).isNull() ? 0 : 1);
            assertThat(bySoap.texts(list + ".item"))
                    .hasSize(byRest.json().path(list).size());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"NaN", "INF", "-INF", "1e999", "0x10", "", "twenty", "1,5"})
    void takesNoNumberThatJsonHasNot(String number) {
        ScriptedVehicle vehicle = tenant.vehicle();

        assertThatThrownBy(() -> soap.call("takeoff", "droneId", vehicle.id(), "altitude", number))
                .isInstanceOfSatisfying(SoapClient.Refused.class, refused -> {
                    assertThat(refused.member("status")).isEqualTo("422");
                    assertThat(refused.member("field")).isEqualTo("altitude");
                });
        assertThat(vehicle.performed()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "<droneId>ID</droneId><altitude>9</altitude><altitude>9</altitude>",
                "<droneId>ID</droneId><altitude>9</altitude><droneId>ID</droneId>",
                "<droneId>ID</droneId><altitude><high>9</high></altitude>",
                "<droneId>ID</droneId><altitude>9</altitude><Altitude>9</Altitude>",
                "<droneId><id>ID</id></droneId><altitude>9</altitude>",
                "<droneId>ID</droneId><altitude>9</altitude><id>&#1;</id>",
                "<droneId>../ID</droneId><altitude>9</altitude>",
                "<altitude>9</altitude>"
            })
    void doesNothingForACallThatIsNotWhatTheSchemaSays(String elements) {
        ScriptedVehicle vehicle = tenant.vehicle();

        TestHttpClient.Answer answer = version(SOAP_11, "takeoff", elements.replace("ID", vehicle.id()));

        assertThat(answer.status()).isEqualTo(500);
        assertThat(answer.raw().body()).containsPattern("<faultcode>\\w+:Client</faultcode>");
        assertThat(ExposedOperations.wrong(answer.raw().body())).isIn("invalid-value", "malformed");
        assertThat(vehicle.performed()).isEmpty();
    }

    @Test
    void refusesXmlThatIsTooDeepInBothVersions() {
        String deep = "<droneId>" + "<a>".repeat(100) + "</a>".repeat(100) + "</droneId>";
        for (String version : List.of(SOAP_11, SOAP_12)) {
            TestHttpClient.Answer answer = version(version, "getDrone", deep);

            assertThat(answer.raw().body())
                    .contains(version, "This XML has more elements, or deeper ones, than are allowed here.");
        }
    }
}
