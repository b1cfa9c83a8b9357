package org.dronemap.ws.http;

import jakarta.servlet.ServletException;
import java.io.IOException;
import org.apache.catalina.connector.Request;
import org.apache.catalina.connector.Response;
import org.apache.catalina.valves.ValveBase;

/**
 * Tells the version of the server with each answer of REST, also to what the web server itself refuses, so that programs
 * can say what a server lacks.
 */
public final class VersionHeaderValve extends ValveBase {
    public static final String HEADER = "Dronemap-Version";

    private final String version;

    public VersionHeaderValve(String version) {
        super(true);
        this.version = version;
    }

    @Override
    public void invoke(Request request, Response response) throws IOException, ServletException {
        response.setHeader(HEADER, version);
        getNext().invoke(request, response);
    }
}
