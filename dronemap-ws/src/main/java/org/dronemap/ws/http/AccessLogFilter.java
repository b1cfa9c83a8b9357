package org.dronemap.ws.http;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.web.filter.OncePerRequestFilter;

/** Logs one line for each HTTP request that changes something or fails, without query, headers or body. */
public final class AccessLogFilter extends OncePerRequestFilter {
    private static final Logger LOG = LoggerFactory.getLogger("org.dronemap.access");

    @Override
    protected void doFilterInternal(HttpServletRequest request, HttpServletResponse response, FilterChain chain)
            throws ServletException, IOException {
        long began = System.nanoTime();
        try {
            chain.doFilter(request, response);
        } finally {
            long millis = (System.nanoTime() - began) / 1_000_000;
            boolean reading = request.getMethod().equals("GET") && response.getStatus() < 400;
            String path = request.getRequestURI().replaceAll("\\p{Cntrl}", "?");
            if (reading) {
                LOG.debug("{} GET {} {} {} ms", request.getRemoteAddr(), path, response.getStatus(), millis);
            } else {
                LOG.info(
                        "{} {} {} {} {} ms",
                        request.getRemoteAddr(),
                        request.getMethod(),
                        path,
                        response.getStatus(),
                        millis);
            }
        }
    }
}
