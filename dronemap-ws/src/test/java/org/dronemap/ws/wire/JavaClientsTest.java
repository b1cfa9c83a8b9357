package org.dronemap.ws.wire;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Method;
import java.nio.file.Path;
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
        Method main = Class.forName("com.sun.tools.ws.WsImport").getMethod("doMain", String[].class);
        String wsdl = WSDL.resolve(service + ".wsdl").toString();
        Object ended = main.invoke(null, (Object) new String[] {"-quiet", "-d", made.toString(), wsdl});

        assertThat(ended).isEqualTo(0);
        assertThat(made.resolve("org/dronemap/cloud/wsdl/" + service + ".class"))
                .exists();
    }
}
