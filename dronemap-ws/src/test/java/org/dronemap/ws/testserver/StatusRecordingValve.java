package org.dronemap.ws.testserver;

import jakarta.servlet.ServletException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.apache.catalina.AccessLog;
import org.apache.catalina.connector.Request;
import org.apache.catalina.connector.Response;
import org.apache.catalina.valves.ValveBase;
import org.jspecify.annotations.Nullable;
import org.springframework.boot.tomcat.TomcatWebServer;
import org.springframework.boot.web.server.context.WebServerApplicationContext;
import org.springframework.context.ConfigurableApplicationContext;

/**
 * Writes down with which statuses the operations of REST answered in this JVM, whoever asked: one line for each operation and
 * status, when it is first seen, into the folder that DRONEMAP_SEEN_STATUSES names. At its end `./dronemap test` holds them
 * against those that the description lists. What SOAP asks of REST within the server is not seen here. Any thread.
 */
final class StatusRecordingValve extends ValveBase implements AccessLog {
    /** Null: nobody wants to know. */
    private static final @Nullable String FOLDER = System.getenv("DRONEMAP_SEEN_STATUSES");

    private static final Set<String> SEEN = ConcurrentHashMap.newKeySet();

    private boolean attributesRead;

    private StatusRecordingValve() {
        super(true);
    }

    /** Watches a server that nobody has asked anything yet. */
    static ConfigurableApplicationContext watch(ConfigurableApplicationContext faces) {
        if (FOLDER == null) {
            return faces;
        }
        if (faces instanceof WebServerApplicationContext context
                && context.getWebServer() instanceof TomcatWebServer server) {
            server.getTomcat().getEngine().getPipeline().addValve(new StatusRecordingValve());
            return faces;
        }
        throw new IllegalStateException("The server is not a Tomcat whose answers can be watched.");
    }

    @Override
    public void invoke(Request request, Response response) throws IOException, ServletException {
        getNext().invoke(request, response);
    }

    /** The end of each request, also of one that was answered by another thread or refused by the web server itself. */
    @Override
    public void log(@Nullable Request request, @Nullable Response response, long nanos) {
        if (request == null || response == null || request.getRequestURI() == null) {
            return;
        }
        seen(request.getMethod(), request.getRequestURI(), response.getStatus());
    }

    /** A client has it: who ends the connection at once may have an answer that the server does not log any more. */
    static void seen(String method, String path, int status) {
        if (FOLDER != null) {
            DeclaredStatuses.operation(method, path)
                    .map(operation -> operation + " " + status)
                    .filter(SEEN::add)
                    .ifPresent(line -> write(FOLDER, line));
        }
    }

    /** Several servers of a JVM write into one file, each line at once. */
    private static void write(String folder, String line) {
        Path file = Path.of(folder, "java-" + ProcessHandle.current().pid() + ".txt");
        try {
            Files.writeString(file, line + "\n", StandardOpenOption.CREATE, StandardOpenOption.APPEND);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    public void setRequestAttributesEnabled(boolean enabled) {
        attributesRead = enabled;
    }

    @Override
    public boolean getRequestAttributesEnabled() {
        return attributesRead;
    }
}
