package org.dronemap.ws.house;

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
 * status, when it is first seen. At its end `./dronemap test` holds them against those that the description lists. What SOAP
 * asks of REST within the server is not seen here. Any thread.
 */
final class SeenStatuses extends ValveBase implements AccessLog {
    private static final Path FILE =
            Path.of("target", "seen-statuses", ProcessHandle.current().pid() + ".txt");
    private static final Set<String> SEEN = ConcurrentHashMap.newKeySet();

    private boolean attributesRead;

    private SeenStatuses() {
        super(true);
    }

    /** Watches a server that nobody has asked anything yet. */
    static ConfigurableApplicationContext watch(ConfigurableApplicationContext faces) {
        if (faces instanceof WebServerApplicationContext context
                && context.getWebServer() instanceof TomcatWebServer server) {
            server.getTomcat().getEngine().getPipeline().addValve(new SeenStatuses());
            return faces;
        }
        throw new IllegalStateException("The server is not a Tomcat whose answers can be watched.");
    }

    @Override
    public void invoke(Request request, Response response) throws IOException, jakarta.servlet.ServletException {
        getNext().invoke(request, response);
    }

    /** The end of each request, also of one that was answered by another thread or refused by the web server itself. */
    @Override
    public void log(@Nullable Request request, @Nullable Response response, long nanos) {
        if (request == null || response == null || request.getRequestURI() == null) {
            return;
        }
        ListedStatuses.operation(request.getMethod(), request.getRequestURI())
                .map(operation -> operation + " " + response.getStatus())
                .filter(SEEN::add)
                .ifPresent(SeenStatuses::write);
    }

    private static synchronized void write(String line) {
        try {
            Files.createDirectories(FILE.getParent());
            Files.writeString(FILE, line + "\n", StandardOpenOption.CREATE, StandardOpenOption.APPEND);
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
