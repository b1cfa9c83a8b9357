package org.dronemap.ws.wire;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.tools.ws.wscompile.WsimportTool;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Clients that Java's own tool makes of the descriptions as they are approved, and that compile. */
class JavaClientsTest {
    private static final Path WSDL = Path.of("src", "test", "resources", "wire", "wsdl");

    @TempDir
    Path made;

    @ParameterizedTest
    @ValueSource(
            strings = {
                "MAVLinkControllerService",
                "FollowerService",
                "PlanningService",
                "VirtualDroneService",
                "RecordService",
                "FleetService",
                "AccountService",
                "ServerService"
            })
    void areMadeOfEachService(String service) throws Exception {
        ByteArrayOutputStream said = new ByteArrayOutputStream();
        boolean well = new WsimportTool(said)
                .run(List.of(
                                "-d",
                                made.toString(),
                                WSDL.resolve(service + ".wsdl").toString())
                        .toArray(String[]::new));

        assertThat(well).as(said.toString(StandardCharsets.UTF_8)).isTrue();
        assertThat(made.resolve("org/dronemap/cloud/wsdl/" + service + ".class"))
                .exists();
    }
}
