package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.net.http.HttpRequest;
import java.util.List;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.Command;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.core.parameter.ParameterType;
import org.dronemap.core.parameter.ParameterValue;
import org.dronemap.ws.testserver.ScriptedVehicle;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.testserver.TestTenant;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class ParametersTest {
    private static final List<Parameter> HELD = List.of(
            new Parameter("RTL_ALT", ParameterType.INT16, 1500), new Parameter("RATE_P", ParameterType.REAL32, 0.1f));

    @AutoClose
    private final TestTenant tenant = new TestTenant();

    private final TestServer house = tenant.server();
    private ScriptedVehicle vehicle;
    private TestHttpClient operator;
    private String path;

    @BeforeEach
    void open() {
        vehicle = tenant.vehicle();
        operator = tenant.http(Role.OPERATOR);
        path = "/api/v1/drones/" + vehicle.id() + "/parameters";
    }

    private void read() {
        vehicle.says(new DroneEvent.ParametersRead(HELD));
        await().until(() -> operator.get(path).json().path("total").asInt() == 2);
    }

    private TestHttpClient.Answer put(String name, String body) {
        return operator.send(
                path + "/" + name + "?wait=10",
                builder -> builder.header("Content-Type", "application/json")
                        .PUT(HttpRequest.BodyPublishers.ofString(body)));
    }

    private TestHttpClient.Answer file(String query, String text) {
        return operator.send(
                path + "/file" + query,
                builder ->
                        builder.header("Content-Type", "text/plain").POST(HttpRequest.BodyPublishers.ofString(text)));
    }

    @Test
    void knowsNothingBeforeItRead() {
        assertThat(operator.get(path).json().path("readAt").isNull()).isTrue();
        assertThat(operator.get(path + "/file").status()).isEqualTo(409);
        assertThat(file("", "RTL_ALT,1").text("detail")).contains("have not been read yet");
    }

    @Test
    void changesOneThroughTheGate() {
        read();

        assertThat(put("RTL_ALT", "{\"value\":2000}")
                        .json()
                        .path("outcome")
                        .path("result")
                        .asString())
                .isEqualTo("succeeded");
        assertThat(vehicle.performed())
                .containsExactly(new Command.SetParameters(List.of(new ParameterValue("RTL_ALT", 2000))));
    }

    @Test
    void refusesWhatTheParameterCannotHold() {
        read();

        TestHttpClient.Answer tooLarge = put("RTL_ALT", "{\"value\":40000}");
        TestHttpClient.Answer unknown = put("NOBODY", "{\"value\":1}");
        TestHttpClient.Answer line = file("", "# none\nRATE_P=0x");

        assertThat(tooLarge.status()).isEqualTo(422);
        assertThat(tooLarge.text("allowed")).isEqualTo("a whole number from -32768 to 32767");
        assertThat(unknown.text("field")).isEqualTo("name");
        assertThat(line.text("detail"))
                .isEqualTo(
                        "There is no value for the autopilot in this file. Line 2: The value of RATE_P, \"0x\", is no"
                                + " number.");
        assertThat(vehicle.performed()).isEmpty();
    }

    @Test
    void comparesAFileAndSendsOnlyWhatDiffers() {
        read();
        String text = "RTL_ALT,1600\nRATE_P,0.1\nOTHER,3\n";

        TestHttpClient.Answer dry = file("?dryRun=true", text);
        assertThat(dry.json().path("different").size()).isEqualTo(1);
        assertThat(dry.json().path("same").asInt()).isEqualTo(1);
        assertThat(dry.json().path("unknown").get(0).asString()).isEqualTo("OTHER");
        assertThat(vehicle.performed()).isEmpty();

        assertThat(file("", text).status()).isEqualTo(202);
        await().until(() -> !vehicle.performed().isEmpty());
        assertThat(vehicle.performed())
                .containsExactly(new Command.SetParameters(List.of(new ParameterValue("RTL_ALT", 1600))));
    }

    @Test
    void letsAViewerLookButNotChange() {
        read();
        TestHttpClient viewer = tenant.http(Role.VIEWER);

        assertThat(viewer.get(path + "?search=rtl").json().path("parameters").size())
                .isEqualTo(1);
        assertThat(viewer.post(path + "/refresh", "").status()).isEqualTo(403);
    }
}
