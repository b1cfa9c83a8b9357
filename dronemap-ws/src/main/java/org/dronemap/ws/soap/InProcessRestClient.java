package org.dronemap.ws.soap;

import jakarta.servlet.DispatcherType;
import jakarta.servlet.Filter;
import jakarta.servlet.Servlet;
import jakarta.servlet.ServletContext;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServlet;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.dronemap.core.audit.AuditedCall;
import org.dronemap.ws.problem.ProblemView;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.security.CurrentPrincipal;
import org.dronemap.ws.security.ForwardedCaller;
import org.dronemap.ws.security.ProblemWriter;
import org.jspecify.annotations.Nullable;
import org.springframework.mock.web.MockAsyncContext;
import org.springframework.mock.web.MockFilterChain;
import org.springframework.mock.web.MockHttpServletRequest;

/**
 * Carries out SOAP calls as REST requests within the server, through the same filters and handlers as over HTTP. Any
 * thread; a call that waits for an outcome holds none.
 */
public final class InProcessRestClient {
    private static final String UTF_8 = "UTF-8";

    private final Servlet dispatcher;
    private final List<? extends Filter> filters;
    private final ProblemWriter problems;

    /** {@code filters}: those that judge and note a request, in their order. */
    public InProcessRestClient(Servlet dispatcher, List<? extends Filter> filters, ProblemWriter problems) {
        this.dispatcher = dispatcher;
        this.filters = filters;
        this.problems = problems;
    }

    /**
     * {@code from}: what the request came in, for the address that it came from; {@code xmlWriter}: null: nothing is written as
     * XML. The answer comes when it is whole; it never
     * fails.
     */
    CompletableFuture<RestResponse> call(
            HttpServletRequest from,
            RestRequest asked,
            ForwardedCaller caller,
            RestResponse.@Nullable BodyWriter xmlWriter) {
        // This request keeps the record.
        AuditedCall.current().ifPresent(AuditedCall::leaveOut);
        MockHttpServletRequest request = request(from, asked);
        CurrentPrincipal.from(request, caller);
        RestResponse answer = new RestResponse(xmlWriter);
        CompletableFuture<RestResponse> whole = new CompletableFuture<>();
        go(asked.refusal().<Servlet>map(this::refusing).orElse(dispatcher), request, answer);
        if (request.isAsyncStarted() && request.getAsyncContext() instanceof MockAsyncContext later) {
            later.addDispatchHandler(() -> {
                request.setDispatcherType(DispatcherType.ASYNC);
                request.setAsyncStarted(false);
                go(dispatcher, request, answer);
                later.complete();
                whole.complete(answer);
            });
        } else {
            whole.complete(answer);
        }
        return whole;
    }

    /** What REST answers to anybody at an address of it. */
    public byte[] read(ServletContext context, String uri) {
        RestResponse answer = new RestResponse(null);
        go(dispatcher, new MockHttpServletRequest(context, "GET", uri), answer);
        if (answer.getStatus() != HttpServletResponse.SC_OK) {
            throw new IllegalStateException(uri + " was answered with status " + answer.getStatus());
        }
        return answer.getContentAsByteArray();
    }

    /** Stands where a handler would read what is wrong with the request: who may not make it has been told so before. */
    private HttpServlet refusing(Rejection why) {
        return new HttpServlet() {
            private static final long serialVersionUID = 1L;

            @Override
            protected void service(HttpServletRequest request, HttpServletResponse response) throws IOException {
                problems.write(response, ProblemView.of(why));
            }
        };
    }

    private void go(Servlet handler, MockHttpServletRequest request, RestResponse answer) {
        try {
            new MockFilterChain(handler, filters.toArray(Filter[]::new)).doFilter(request, answer);
        } catch (ServletException | IOException | RuntimeException e) {
            answer.failed(e);
        }
    }

    private MockHttpServletRequest request(HttpServletRequest from, RestRequest asked) {
        MockHttpServletRequest request =
                new MockHttpServletRequest(from.getServletContext(), asked.method(), asked.uri());
        request.setAsyncSupported(true);
        request.setServletPath(asked.uri());
        request.setRemoteAddr(from.getRemoteAddr());
        request.setRemotePort(from.getRemotePort());
        request.setScheme(from.getScheme());
        request.setSecure(from.isSecure());
        request.setServerName(from.getServerName());
        request.setServerPort(from.getServerPort());
        request.addHeader("Accept", "application/json, */*;q=0.1");
        asked.query().forEach(request::addParameter);
        asked.body().ifPresent(body -> {
            request.setContentType(body.mediaType());
            request.setContent(body.bytes());
            request.setCharacterEncoding(UTF_8);
        });
        return request;
    }
}
