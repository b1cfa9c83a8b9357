package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.ws.testserver.ExposedOperations;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.SoapClient;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Whose mistake a SOAP fault calls it, and what it says of XML that cannot be read. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class SoapFaultsTest {
    private static final String CONTROLLER = "/services/MAVLinkControllerService";
    private static final String OF_THE_CALLER = "<faultcode>\\w+:Client</faultcode>";

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestServer house = tenant.server();
    private ScriptedVehicle vehicle;
    private TestHttpClient operator;

    @BeforeAll
    void open() {
        vehicle = tenant.vehicle();
        operator = tenant.http(Role.OPERATOR);
    }

    private static TestHttpClient.Answer call(TestHttpClient caller, String operation) {
        return caller.send(
                CONTROLLER,
                request -> request.header("Content-Type", "text/xml")
                        .POST(HttpRequest.BodyPublishers.ofString(SoapClient.envelope("", operation))));
    }

    private String fault(String operation) {
        TestHttpClient.Answer answer = call(operator, operation);
        assertThat(answer.status()).isEqualTo(500);
        return answer.raw().body();
    }

    @Test
    void isTheCallersForABadValueAStrangerAndAnUnknownDrone() {
        String badValue = fault("<w:goto><droneId>" + vehicle.id()
                + "</droneId><latitude>95</latitude><longitude>8</longitude><altitude>20</altitude></w:goto>");
        String stranger =
                call(new TestHttpClient(house, ""), "<w:getDronesList/>").raw().body();
        String unknown = fault("<w:land><droneId>nosuchdrone</droneId></w:land>");

        assertThat(badValue)
                .containsPattern(OF_THE_CALLER)
                .contains("<code>value-out-of-range</code>", "problem:invalid-value</type>")
                .contains("<field>latitude</field>")
                .contains("<allowed>-90 to 90 degrees</allowed>");
        assertThat(stranger).containsPattern(OF_THE_CALLER).contains("<code>sign-in-needed</code>");
        assertThat(unknown).containsPattern(OF_THE_CALLER).contains("<code>drone-unknown</code>");
    }

    static Stream<Arguments> unreadableValues() {
        return Stream.of(
                Arguments.of(
                        "<w:takeoff><droneId>x</droneId><altitude>high</altitude></w:takeoff>", "altitude", "a number"),
                Arguments.of(
                        "<w:setRelay><droneId>x</droneId><relay>one</relay></w:setRelay>", "relay", "a whole number"),
                Arguments.of("<w:disarm><droneId>x</droneId><force>maybe</force></w:disarm>", "force", "true or false"),
                Arguments.of(
                        "<w:uploadMission><droneId>x</droneId><items><item><waypoint><latitude>47</latitude></waypoint></item>"
                                + "<item><waypoint><latitude>47N</latitude></waypoint></item></items></w:uploadMission>",
                        "items[1].latitude",
                        "a number"));
    }

    @ParameterizedTest
    @MethodSource("unreadableValues")
    void namesTheFieldAndWhatIsAllowed(String operation, String field, String allowed) {
        assertThat(fault(operation))
                .containsPattern(OF_THE_CALLER)
                .contains("<code>value-malformed</code>", "<field>" + field + "</field>")
                .contains("<allowed>" + allowed + "</allowed>")
                .contains("\"" + field + "\" must be " + allowed + ".")
                .doesNotContain("Unmarshalling", "Exception");
    }

    @Test
    void namesMisspeltElementsHoweverManyCameBefore() {
        IntStream.range(0, 15)
                .forEach(attempt -> assertThat(fault("<w:uploadMission><droneId>" + vehicle.id()
                                + "</droneId><items><item><waypoint><latitude>47</latitude><longitude>8</longitude>"
                                + "<altitude>20</altitude><altitudereference>amsl</altitudereference></waypoint>"
                                + "</item></items></w:uploadMission>"))
                        .containsPattern(OF_THE_CALLER)
                        .contains("<field>items[0].altitudereference</field>")
                        .contains("<allowed>latitude, longitude, altitude, altitudeReference, holdSeconds</allowed>"));
        assertThat(fault("<w:takeoff><droneId>x</droneId><altitud>5</altitud></w:takeoff>"))
                .contains("<field>altitud</field>", "<allowed>droneId, altitude, id, epoch, wait</allowed>");
        assertThat(vehicle.performed()).isEmpty();
    }

    @Test
    void saysInItsOwnWordsThatXmlIsNotWellFormed() {
        assertThat(fault("<w:land><droneId>x</w:land>"))
                .containsPattern(OF_THE_CALLER)
                .contains("This is not well-formed XML.")
                .doesNotContain("Exception", "XMLStreamReader");
    }

    @Test
    void tellsOfAnElementThatThereIsNotByTheNamesOfElements() {
        String drone = "<droneId>" + vehicle.id() + "</droneId>";

        assertThat(fault("<w:takeoff>" + drone + "<altitud>20</altitud></w:takeoff>"))
                .contains("<code>member-unknown</code>", "<entry key=\"field\" type=\"string\">altitud</entry>")
                .contains("There is no element \"altitud\" here; there are: droneId, altitude,")
                .doesNotContain("type, altitude");
        assertThat(fault("<w:uploadMission>" + drone
                        + "<items><item><takeOff><hight>20</hight></takeOff></item></items></w:uploadMission>"))
                .contains(
                        "<code>member-unknown</code>",
                        "There is no element \"items[0].hight\" here; there are: altitude");
        assertThat(fault("<w:uploadMission>" + drone
                        + "<items><item><type>land</type></item></items></w:uploadMission>"))
                .contains("must be takeOff, waypoint,", ", not \"type\".");
    }

    @Test
    void callsAnUnknownOperationTheCallersMistake() {
        assertThat(fault("<w:fly><droneId>x</droneId></w:fly>"))
                .containsPattern(OF_THE_CALLER)
                .doesNotContain("Exception");
    }

    @Test
    void isNeverTheServersForACallWithoutElements() {
        ExposedOperations faces = new ExposedOperations(house);
        for (String operation : faces.soap()) {
            TestHttpClient.Answer answer = faces.call(operator, operation, "");
            if (answer.status() == 500) {
                assertThat(answer.raw().body())
                        .as(operation)
                        .containsPattern(OF_THE_CALLER)
                        .doesNotContain("Exception");
            }
        }
    }

    @Test
    void namesAnElementThatIsMissing() {
        assertThat(fault("<w:land/>"))
                .containsPattern(OF_THE_CALLER)
                .contains("<field>droneId</field>", "\"droneId\" is missing");
    }

    /** Some clients qualify what the schema has without a namespace. */
    @Test
    void passesOverNoElementThatIsInANamespace() {
        String id = vehicle.id();

        assertThat(call(operator, "<w:getDrone><w:droneId>" + id + "</w:droneId></w:getDrone>")
                        .raw()
                        .body())
                .contains("<id>" + id + "</id>");
        assertThat(fault("<w:takeoff><droneId>" + id + "</droneId><w:altitude>5</w:altitude><altitude>9</altitude>"
                        + "</w:takeoff>"))
                .contains("<field>altitude</field>");
        assertThat(vehicle.performed()).isEmpty();
    }

    @Test
    void takesAKeyInTheHeaderBesideTheCall() {
        String envelope = SoapClient.envelope(
                "<w:accessKey>" + tenant.key(Role.VIEWER) + "</w:accessKey>",
                "<w:getDrone><droneId>" + vehicle.id() + "</droneId></w:getDrone>");
        TestHttpClient.Answer answer = new TestHttpClient(house, "")
                .send(
                        CONTROLLER,
                        request -> request.header("Content-Type", "text/xml")
                                .POST(HttpRequest.BodyPublishers.ofString(envelope)));

        assertThat(answer.status()).isEqualTo(200);
        assertThat(answer.raw().body()).contains("<id>" + vehicle.id() + "</id>");
    }
}
