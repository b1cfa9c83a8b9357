package org.dronemap.ws.security;

import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.dronemap.ws.access.AuditNotes;
import org.dronemap.ws.problem.ProblemView;
import org.dronemap.ws.reading.JsonCodec;

/** Writes a problem response from a servlet filter, where no REST handler is involved. */
public final class ProblemWriter {
    private final JsonCodec json;

    public ProblemWriter(JsonCodec json) {
        this.json = json;
    }

    public void write(HttpServletResponse response, ProblemView problem) throws IOException {
        AuditNotes.turnedAway(problem);
        byte[] body = json.write(problem).getBytes(StandardCharsets.UTF_8);
        response.setStatus(problem.status());
        response.setContentType("application/problem+json");
        Long wait = problem.retryAfterSeconds();
        if (wait != null) {
            response.setHeader("Retry-After", wait.toString());
        }
        response.setContentLength(body.length);
        response.getOutputStream().write(body);
    }
}
