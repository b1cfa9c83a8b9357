package org.dronemap.ws.security;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.apache.catalina.connector.Request;
import org.apache.catalina.connector.Response;
import org.apache.catalina.valves.ErrorReportValve;
import org.dronemap.ws.problem.ProblemView;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RequestProblem;
import org.dronemap.ws.reading.JsonCodec;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Answers requests that Tomcat itself refuses, such as broken URIs, in the problem format of the API. */
public final class TomcatErrorValve extends ErrorReportValve {
    private static final Logger LOG = LoggerFactory.getLogger(TomcatErrorValve.class);
    private static final int BAD_REQUEST = 400;

    private final JsonCodec json;

    public TomcatErrorValve(JsonCodec json) {
        this.json = json;
    }

    @Override
    protected void report(Request request, Response response, @Nullable Throwable failure) {
        int status = response.getStatus();
        if (status < BAD_REQUEST || response.getContentWritten() > 0 || !response.setErrorReported()) {
            return;
        }
        ProblemView problem = status == BAD_REQUEST
                ? ProblemView.of(Rejection.of(
                        RequestProblem.REQUEST_UNREADABLE,
                        "The request cannot be read: its address has a broken escape or a character that must be"
                                + " escaped, or a header is malformed."))
                : ProblemView.ofStatus(status);
        try {
            response.setContentType("application/problem+json");
            response.getOutputStream().write(json.write(problem).getBytes(StandardCharsets.UTF_8));
            response.finishResponse();
        } catch (IOException e) {
            LOG.debug("A client went away before it was told what is wrong", e);
        }
    }
}
