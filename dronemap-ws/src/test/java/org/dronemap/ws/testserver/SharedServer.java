package org.dronemap.ws.testserver;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.dronemap.core.access.Role;
import org.jspecify.annotations.Nullable;

/**
 * The server that all tests of one JVM share: started when the first of them asks for it, closed when the JVM ends. Whoever
 * uses it leaves its settings alone, puts back what concerns everybody, and looks for nothing but their own users and drones.
 */
public final class SharedServer {
    private static @Nullable TestServer server;
    private static @Nullable TestHttpClient administrator;

    private SharedServer() {}

    public static synchronized TestServer get() {
        TestServer running = server;
        if (running == null) {
            running = new TestServer(directory(), false);
            Runtime.getRuntime().addShutdownHook(new Thread(running::close, "close the shared server"));
            server = running;
        }
        return running;
    }

    /** Of the organisation that runs the server. */
    static synchronized TestHttpClient administrator() {
        TestHttpClient known = administrator;
        if (known == null) {
            known = new TestHttpClient(get(), get().key(Role.ADMINISTRATOR));
            administrator = known;
        }
        return known;
    }

    /** Goes with everything else that was built. */
    private static Path directory() {
        try {
            Path servers = Files.createDirectories(Path.of("target", "shared-servers"));
            return Files.createTempDirectory(servers, "data").toAbsolutePath();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
