package org.dronemap.ws.soap;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.stream.Collectors;
import org.dronemap.ws.problem.ProblemView;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RequestProblem;
import org.dronemap.ws.security.ProblemWriter;
import org.dronemap.ws.soap.description.SoapService;
import org.dronemap.ws.soap.description.SoapServices;
import org.dronemap.ws.soap.description.WsdlWriter;
import org.springframework.web.filter.OncePerRequestFilter;

/** Serves the WSDL of each SOAP service at {@code ?wsdl}, and answers unknown addresses under /services. */
public final class WsdlFilter extends OncePerRequestFilter {
    private static final String SERVICES = "/services/";

    private final SoapServicePublisher published;
    private final ProblemWriter problems;

    public WsdlFilter(SoapServicePublisher published, ProblemWriter problems) {
        this.published = published;
        this.problems = problems;
    }

    @Override
    protected void doFilterInternal(HttpServletRequest request, HttpServletResponse response, FilterChain chain)
            throws ServletException, IOException {
        String uri = request.getRequestURI();
        SoapServices services = published.services();
        Optional<SoapService> service =
                services.service(uri.startsWith(SERVICES) ? uri.substring(SERVICES.length()) : "");
        if (service.isEmpty()) {
            problems.write(response, ProblemView.of(nothingHere(uri, services)));
        } else if (request.getMethod().equals("POST")) {
            chain.doFilter(request, response);
        } else if (isAskedFor(request)) {
            String wsdl = WsdlWriter.write(
                    service.get(), services.types(), request.getRequestURL().toString());
            byte[] bytes = wsdl.getBytes(StandardCharsets.UTF_8);
            response.setContentType("text/xml;charset=UTF-8");
            response.setContentLength(bytes.length);
            response.getOutputStream().write(bytes);
        } else {
            problems.write(
                    response,
                    ProblemView.of(Rejection.of(
                            RequestProblem.METHOD_NOT_TAKEN,
                            "This service takes SOAP by POST; GET " + uri + "?wsdl describes it.")));
        }
    }

    private static boolean isAskedFor(HttpServletRequest request) {
        return request.getMethod().equals("GET") && "wsdl".equalsIgnoreCase(request.getQueryString());
    }

    private static Rejection nothingHere(String uri, SoapServices services) {
        return Rejection.of(
                RequestProblem.ADDRESS_UNKNOWN,
                "There is nothing at " + uri + "; the SOAP services are described at "
                        + services.services().keySet().stream()
                                .map(name -> SERVICES + name + "?wsdl")
                                .collect(Collectors.joining(", "))
                        + ".");
    }
}
