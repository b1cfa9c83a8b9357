package org.dronemap.ws.rest;

import jakarta.servlet.AsyncEvent;
import jakarta.servlet.AsyncListener;
import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Set;
import org.dronemap.core.audit.Activity;
import org.dronemap.core.audit.AuditDesk;
import org.dronemap.core.audit.AuditOutcome;
import org.dronemap.ws.service.AuditRules;
import org.springframework.web.filter.OncePerRequestFilter;

/**
 * Takes each request down that may change something, whoever it comes from and whatever becomes of it. The answer leaves
 * when the record is there.
 */
public final class AuditFilter extends OncePerRequestFilter {
    private static final String API = "/api/";
    private static final String SOAP = "/services/";
    private static final int FIRST_BAD_STATUS = 400;
    private static final int FIRST_OWN_FAULT = 500;

    /** Of these the place that they come from is told in any case. */
    private static final Set<String> AT_THE_DOOR = Set.of("POST /api/v1/session", "POST /api/v1/registrations");

    private final AuditDesk desk;
    private final AuditedOperations operations;

    public AuditFilter(AuditDesk desk, AuditedOperations operations) {
        this.desk = desk;
        this.operations = operations;
    }

    @Override
    protected boolean shouldNotFilter(HttpServletRequest request) {
        String path = request.getRequestURI();
        return AuditRules.onlyLooks(request.getMethod(), path) || !(path.startsWith(API) || path.startsWith(SOAP));
    }

    @Override
    protected void doFilterInternal(HttpServletRequest request, HttpServletResponse response, FilterChain chain)
            throws ServletException, IOException {
        Activity call = request.getRequestURI().startsWith(SOAP) ? desk.begin("soap", "unreadable") : rest(request);
        HeldResponse held = new HeldResponse(response, () -> finish(call, request, response));
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

    private Activity rest(HttpServletRequest request) {
        AuditedOperations.Operation operation = operations.of(request);
        Activity call = desk.begin("rest", operation.name());
        call.drone(operation.drone());
        call.parameters(operation.parameters());
        if (AT_THE_DOOR.contains(operation.name())) {
            call.parameters("from " + request.getRemoteAddr());
        }
        if (AuditRules.leavesOutRest(operation.name())) {
            call.leaveOut();
        } else if (AuditRules.recordsElsewhere(operation.name())) {
            call.leaveOutUnlessTurnedAway();
        }
        return call;
    }

    private void end(Activity call, HttpServletRequest request, HeldResponse response) {
        response.letGo();
        if (request.isAsyncStarted()) {
            request.getAsyncContext().addListener(new AtTheEnd(call, request, response));
        } else {
            finish(call, request, response);
        }
    }

    private void finish(Activity call, HttpServletRequest request, HttpServletResponse response) {
        int status = response.getStatus();
        if (status >= FIRST_BAD_STATUS) {
            call.turnedAway(
                    status >= FIRST_OWN_FAULT ? AuditOutcome.FAILED : AuditOutcome.REFUSED,
                    "It was answered with status " + status + ".");
        }
        if (call.entry().by() == null && !AT_THE_DOOR.contains(call.entry().operation())) {
            call.parameters("from " + request.getRemoteAddr());
        }
        desk.end(call);
    }

    /** For what is answered by another thread. */
    private final class AtTheEnd implements AsyncListener {
        private final Activity call;
        private final HttpServletRequest request;
        private final HttpServletResponse response;

        AtTheEnd(Activity call, HttpServletRequest request, HttpServletResponse response) {
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
