package org.dronemap.ws.http;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.springframework.web.filter.OncePerRequestFilter;

/** Sets the response headers that tell browsers what pages of this server may load, and that nobody may frame them. */
public final class SecurityHeadersFilter extends OncePerRequestFilter {
    /** Half a year; only this very host, as others of its domain are none of our business. */
    private static final String ENCRYPTED_ONLY = "max-age=15552000";

    private static final Pattern DOCUMENTATION = Pattern.compile("/api/(docs|swagger-ui).*");

    private final int streamPort;
    private final String tiles;

    public SecurityHeadersFilter(int streamPort, @Nullable String tileAddress) {
        this.streamPort = streamPort;
        this.tiles = tileAddress == null ? "" : " " + origin(tileAddress);
    }

    @Override
    protected void doFilterInternal(HttpServletRequest request, HttpServletResponse response, FilterChain chain)
            throws ServletException, IOException {
        response.setHeader("Content-Security-Policy", policy(request));
        response.setHeader("X-Content-Type-Options", "nosniff");
        response.setHeader("X-Frame-Options", "DENY");
        response.setHeader("Referrer-Policy", "same-origin");
        response.setHeader("Cross-Origin-Opener-Policy", "same-origin");
        response.setHeader("Cross-Origin-Resource-Policy", "same-origin");
        response.setHeader("Permissions-Policy", "camera=(), microphone=(), geolocation=(self), payment=(), usb=()");
        if (request.isSecure()) {
            response.setHeader("Strict-Transport-Security", ENCRYPTED_ONLY);
        }
        if (request.getRequestURI().startsWith("/api/")) {
            response.setHeader("Cache-Control", "no-store");
        }
        chain.doFilter(request, response);
    }

    private String policy(HttpServletRequest request) {
        String host = request.getServerName();
        // an IPv6 literal cannot be written in a policy
        String name = host.matches("[A-Za-z0-9.-]+") ? host : "*";
        String stream = (request.isSecure() ? "wss://" : "ws://") + name + ":" + streamPort;
        // the viewer of the description is not ours, and styles itself
        String styles = DOCUMENTATION.matcher(request.getRequestURI()).matches() ? "'self' 'unsafe-inline'" : "'self'";
        return "default-src 'self'; script-src 'self'; style-src " + styles + "; img-src 'self' data: blob:"
                + tiles + "; font-src 'self' data:; connect-src 'self' blob: data: " + stream + tiles
                + "; worker-src 'self' blob:; child-src 'self' blob:; object-src 'none'; base-uri 'none';"
                + " form-action 'self'; frame-ancestors 'none'";
    }

    /** Scheme, host and port of a tile address; its placeholders may stand for a part of the host. */
    private static String origin(String address) {
        int path = address.indexOf('/', address.indexOf("://") + 3);
        String origin = path < 0 ? address : address.substring(0, path);
        return origin.replaceAll("^(https?://)[^/]*[}](?:[^./]*)\\.", "$1*.").replaceAll("[;,\\s'\"]", "");
    }
}
