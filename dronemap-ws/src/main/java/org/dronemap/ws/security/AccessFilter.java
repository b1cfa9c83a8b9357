package org.dronemap.ws.security;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import org.dronemap.ws.service.Budgets;
import org.dronemap.ws.service.Problem;
import org.dronemap.ws.service.Rejection;
import org.dronemap.ws.service.Work;
import org.jspecify.annotations.Nullable;
import org.springframework.web.filter.OncePerRequestFilter;

/** Finds out who asks under /api/v1 and for /metrics before anything else happens, and turns away who may not. */
public final class AccessFilter extends OncePerRequestFilter {
    private static final String API = "/api/v1/";
    private static final String METRICS = "/metrics";
    private static final String BEARER = "Bearer ";
    private static final Set<String> OPEN = Set.of("health", "registrations", "session/oidc", "session/oidc/callback");
    private static final Set<String> READING = Set.of("GET", "HEAD", "OPTIONS");

    /** What has no budget here: commands have one of their own, and control must never be lost for want of one. */
    private static final Pattern ON_DRONES = Pattern.compile("(drones/[^/]+/)?commands|drones/[^/]+/control/.*");

    private static final Pattern COSTLY =
            Pattern.compile(".*/file|flights/logbook|backup|replays|recordings/[^/]+/replays|zones/import");

    private final Authentication authentication;
    private final ProblemWriter problems;
    private final Budgets budgets;

    public AccessFilter(Authentication authentication, Budgets budgets, ProblemWriter problems) {
        this.authentication = authentication;
        this.budgets = budgets;
        this.problems = problems;
    }

    @Override
    protected boolean shouldNotFilter(HttpServletRequest request) {
        return !request.getRequestURI().startsWith(API) && !isMetrics(request);
    }

    @Override
    protected void doFilterInternal(HttpServletRequest request, HttpServletResponse response, FilterChain chain)
            throws ServletException, IOException {
        try {
            admit(request);
        } catch (Rejection rejection) {
            problems.write(response, Problem.of(rejection));
            return;
        }
        chain.doFilter(request, response);
    }

    /** However it is written: whatever leads there must be guarded. */
    private static boolean isMetrics(HttpServletRequest request) {
        return METRICS.equals(request.getServletPath())
                || request.getRequestURI().startsWith(METRICS);
    }

    private void admit(HttpServletRequest request) {
        String path = isMetrics(request) ? METRICS : request.getRequestURI().substring(API.length());
        if (isOpen(path, request.getMethod())) {
            budgets.take(path.startsWith("session") ? Work.SIGN_IN : Work.REQUEST, request.getRemoteAddr());
            return;
        }
        SignedIn caller = identify(request).orElseThrow(() -> noCaller(request));
        pay(caller, request.getMethod(), path);
        if (!path.equals("session") && !path.startsWith("session/")) {
            authentication.admit(caller);
        }
        CurrentPrincipal.set(request, caller);
    }

    private static boolean isOpen(String path, String method) {
        return OPEN.contains(path) || (path.equals("session") && method.equals("POST"));
    }

    private void pay(SignedIn caller, String method, String path) {
        String user = caller.principal().name();
        if (method.equals("POST") && ON_DRONES.matcher(path).matches()) {
            return;
        }
        budgets.take(Work.REQUEST, user);
        if (COSTLY.matcher(path).matches()) {
            budgets.take(Work.EXPORT, user);
        }
    }

    private static Rejection noCaller(HttpServletRequest request) {
        return SessionCookie.read(request).isPresent()
                ? Rejection.sessionEnded()
                : Rejection.notSignedIn("Sign in first, or send an access key.");
    }

    private Optional<SignedIn> identify(HttpServletRequest request) {
        String header = request.getHeader("Authorization");
        if (header != null) {
            return Optional.of(authentication.byKey(bearer(header)));
        }
        Optional<SignedIn> caller = SessionCookie.read(request).flatMap(authentication::bySession);
        if (caller.isPresent() && !READING.contains(request.getMethod()) && request.getHeader("X-Dronemap") == null) {
            throw Rejection.forbidden(
                    "A change with a browser's session needs the header X-Dronemap: 1, which other sites cannot send.");
        }
        return caller;
    }

    private static String bearer(@Nullable String header) {
        if (header == null || !header.regionMatches(true, 0, BEARER, 0, BEARER.length())) {
            throw Rejection.notSignedIn("The Authorization header must be: Bearer, a space, and an access key.");
        }
        return header.substring(BEARER.length()).strip();
    }
}
