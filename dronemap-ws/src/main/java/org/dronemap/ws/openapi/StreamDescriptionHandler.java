package org.dronemap.ws.openapi;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.springframework.http.MediaType;
import org.springframework.web.HttpRequestHandler;
import org.springframework.web.servlet.support.WebContentGenerator;

/** Serves the AsyncAPI description of the WebSocket stream over HTTP, without sign-in. */
public final class StreamDescriptionHandler extends WebContentGenerator implements HttpRequestHandler {
    private final Description description;

    /** The stream as it is reached by whoever asks. */
    @FunctionalInterface
    public interface Description {
        /** As JSON; {@code host}: without a port. */
        String at(boolean encrypted, String host);
    }

    public StreamDescriptionHandler(Description description) {
        super(METHOD_GET, METHOD_HEAD);
        this.description = description;
    }

    @Override
    public void handleRequest(HttpServletRequest request, HttpServletResponse response)
            throws ServletException, IOException {
        checkRequest(request);
        byte[] text =
                description.at(request.isSecure(), request.getServerName()).getBytes(StandardCharsets.UTF_8);
        response.setContentType(MediaType.APPLICATION_JSON_VALUE);
        response.setContentLength(text.length);
        response.getOutputStream().write(text);
    }
}
