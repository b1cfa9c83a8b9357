package org.dronemap.ws.http;

import jakarta.servlet.AsyncEvent;
import jakarta.servlet.AsyncListener;
import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.dronemap.core.audit.AuditOutcome;
import org.dronemap.core.audit.AuditRecorder;
import org.dronemap.core.audit.AuditedCall;
import org.dronemap.ws.access.AccessRule;
import org.dronemap.ws.access.AuditPolicy;
import org.dronemap.ws.access.RestOperations;
import org.dronemap.ws.security.CurrentPrincipal;
import org.dronemap.ws.security.ForwardedCaller;
import org.springframework.web.filter.OncePerRequestFilter;

/**
 * Writes an audit record of each HTTP request that may change something, whoever sends it and whatever comes of it. The
 * answer leaves when the record is there.
 */
public final class AuditFilter extends OncePerRequestFilter {
    private static final String API = "/api/";
    private static final String SOAP = "/services/";
    private static final int FIRST_BAD_STATUS = 400;
    private static final int FIRST_OWN_FAULT = 500;

    private final AuditRecorder desk;
    private final RestOperations operations;

    public AuditFilter(AuditRecorder desk, RestOperations operations) {
        this.desk = desk;
        this.operations = operations;
    }

    @Override
    protected boolean shouldNotFilter(HttpServletRequest request) {
        String path = request.getRequestURI();
        if (path.startsWith(SOAP)) {
            return AuditPolicy.onlyLooks(request.getMethod());
        }
        return !path.startsWith(API) || operations.rule(request).audit() == AuditPolicy.ONLY_LOOKS;
    }

    @Override
    protected void doFilterInternal(HttpServletRequest request, HttpServletResponse response, FilterChain chain)
            throws ServletException, IOException {
        AuditedCall call = request.getRequestURI().startsWith(SOAP) ? desk.begin("soap", "unreadable") : rest(request);
        DelayedCommitResponse held = new DelayedCommitResponse(response, () -> finish(call, request, response));
        try {
            call.<Boolean, Exception>during(() -> {
                chain.doFilter(request, held);
                return true;
            });
        } catch (ServletException | IOException | RuntimeException e) {
            call.turnedAway(AuditOutcome.FAILED, "The server failed, or the client went away.");
            throw e;
        } catch (Exception e) {
            throw new ServletException(e);
        } finally {
            end(call, request, held);
        }
    }

    private AuditedCall rest(HttpServletRequest request) {
        AccessRule rule = operations.rule(request);
        AuditedOperation operation = AuditedOperation.of(request, rule.operation());
        String face =
                CurrentPrincipal.otherFace(request).map(ForwardedCaller::face).orElse("rest");
        AuditedCall call = desk.begin(face, operation.name());
        call.drone(operation.drone());
        call.parameters(operation.parameters());
        switch (rule.audit()) {
            case RECORDED_WITH_PLACE -> call.parameters(place(request));
            case REFUSALS_ONLY -> call.leaveOutUnlessTurnedAway();
            case LEFT_OUT -> call.leaveOut();
            case BY_METHOD, RECORDED, ONLY_LOOKS -> {}
        }
        return call;
    }

    private static String place(HttpServletRequest request) {
        return "from " + request.getRemoteAddr();
    }

    private void end(AuditedCall call, HttpServletRequest request, DelayedCommitResponse response) {
        response.letGo();
        if (request.isAsyncStarted()) {
            request.getAsyncContext().addListener(new AuditAsyncListener(call, request, response));
        } else {
            finish(call, request, response);
        }
    }

    private void finish(AuditedCall call, HttpServletRequest request, HttpServletResponse response) {
        int status = response.getStatus();
        if (status >= FIRST_BAD_STATUS) {
            call.turnedAway(
                    status >= FIRST_OWN_FAULT ? AuditOutcome.FAILED : AuditOutcome.REFUSED,
                    "It was answered with status " + status + ".");
        }
        if (call.entry().by() == null && operations.rule(request).audit() != AuditPolicy.RECORDED_WITH_PLACE) {
            call.parameters(place(request));
        }
        desk.end(call);
    }

    /** For what is answered by another thread. */
    private final class AuditAsyncListener implements AsyncListener {
        private final AuditedCall call;
        private final HttpServletRequest request;
        private final HttpServletResponse response;

        AuditAsyncListener(AuditedCall call, HttpServletRequest request, HttpServletResponse response) {
            this.call = call;
            this.request = request;
            this.response = response;
        }

        @Override
        public void onComplete(AsyncEvent event) {
            finish(call, request, response);
        }

        @Override
        public void onTimeout(AsyncEvent event) {
            call.turnedAway(AuditOutcome.FAILED, "It took too long.");
        }

        @Override
        public void onError(AsyncEvent event) {
            call.turnedAway(AuditOutcome.FAILED, "The server failed, or the client went away.");
        }

        @Override
        public void onStartAsync(AsyncEvent event) {
            event.getAsyncContext().addListener(this);
        }
    }
}
