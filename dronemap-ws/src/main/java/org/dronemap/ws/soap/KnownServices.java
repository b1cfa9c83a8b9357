package org.dronemap.ws.soap;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.dronemap.ws.security.ProblemWriter;
import org.dronemap.ws.service.Problem;
import org.dronemap.ws.service.ProblemParameter;
import org.dronemap.ws.service.Rejection;
import org.dronemap.ws.service.RequestProblem;
import org.springframework.web.filter.OncePerRequestFilter;

/** Answers for addresses under /services that are none; the SOAP library would send a page of its own. */
public final class KnownServices extends OncePerRequestFilter {
    private static final String CONTROLLER = "/services" + SoapEndpoint.PATH;
    private static final String FOLLOWER = "/services" + SoapEndpoint.FOLLOWER;

    private final ProblemWriter problems;

    public KnownServices(ProblemWriter problems) {
        this.problems = problems;
    }

    @Override
    protected void doFilterInternal(HttpServletRequest request, HttpServletResponse response, FilterChain chain)
            throws ServletException, IOException {
        String address = request.getServletPath() + (request.getPathInfo() == null ? "" : request.getPathInfo());
        if (address.equals(CONTROLLER) || address.equals(FOLLOWER)) {
            chain.doFilter(request, response);
            return;
        }
        problems.write(
                response,
                Problem.of(Rejection.of(
                        RequestProblem.ADDRESS_UNKNOWN,
                        "There is nothing at " + request.getRequestURI() + "; the SOAP services are described at "
                                + CONTROLLER + "?wsdl and " + FOLLOWER + "?wsdl.",
                        ProblemParameter.ADDRESS.is(request.getRequestURI()))));
    }
}
