package org.dronemap.ws.security;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import java.util.Set;
import org.dronemap.core.access.Role;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.AccessRule;
import org.dronemap.ws.access.RestOperations;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.budget.Budgets;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.ProblemView;
import org.dronemap.ws.problem.Rejection;
import org.jspecify.annotations.Nullable;
import org.springframework.web.filter.OncePerRequestFilter;

/** Authenticates each HTTP request, and rejects callers whom the handler's access rule does not admit, body unread. */
public final class AccessFilter extends OncePerRequestFilter {
    private static final String API = "/api/v1/";
    private static final String METRICS = "/metrics";
    private static final String BEARER = "Bearer ";
    private static final Set<String> READING = Set.of("GET", "HEAD", "OPTIONS");

    private final RestOperations operations;
    private final CallerAuthenticator authentication;
    private final ProblemWriter problems;
    private final Budgets budgets;

    public AccessFilter(
            RestOperations operations, CallerAuthenticator authentication, Budgets budgets, ProblemWriter problems) {
        this.operations = operations;
        this.authentication = authentication;
        this.budgets = budgets;
        this.problems = problems;
    }

    @Override
    protected boolean shouldNotFilter(HttpServletRequest request) {
        String path = request.getRequestURI();
        return !path.startsWith(API)
                && !path.startsWith(METRICS)
                && operations.rule(request).operation() == null;
    }

    @Override
    protected void doFilterInternal(HttpServletRequest request, HttpServletResponse response, FilterChain chain)
            throws ServletException, IOException {
        try {
            admit(request);
        } catch (Rejection rejection) {
            problems.write(response, ProblemView.of(rejection));
            return;
        }
        chain.doFilter(request, response);
    }

    private void admit(HttpServletRequest request) {
        AccessRule rule = operations.rule(request);
        if (rule.from() == AccessLevel.ANYBODY) {
            pay(rule, request.getRemoteAddr());
            return;
        }
        AuthenticatedCaller caller = identify(request).orElseThrow(() -> noCaller(request));
        pay(rule, caller.principal().name());
        Role least = rule.from().role();
        if (least != null) {
            authentication.admit(caller);
            RoleChecks.requireRole(caller.principal(), least);
        }
        CurrentPrincipal.set(request, caller);
    }

    private void pay(AccessRule rule, String who) {
        rule.costs().work().forEach(work -> budgets.charge(work, who));
    }

    private static Rejection noCaller(HttpServletRequest request) {
        return SessionCookie.read(request).isPresent()
                ? Rejection.sessionEnded()
                : Rejection.of(AccessProblem.SIGN_IN_NEEDED, "Sign in first, or send an access key.");
    }

    private Optional<AuthenticatedCaller> identify(HttpServletRequest request) {
        Optional<ForwardedCaller> other = CurrentPrincipal.otherFace(request);
        if (other.isPresent()) {
            return Optional.of(other.get().proved().get());
        }
        String header = request.getHeader("Authorization");
        if (header != null) {
            return Optional.of(authentication.byKey(bearer(header)));
        }
        Optional<AuthenticatedCaller> caller = SessionCookie.read(request).flatMap(authentication::bySession);
        if (caller.isPresent() && !READING.contains(request.getMethod()) && request.getHeader("X-Dronemap") == null) {
            throw Rejection.of(
                    AccessProblem.SESSION_HEADER_MISSING,
                    "A change with a browser's session needs the header X-Dronemap: 1, which other sites cannot send.");
        }
        return caller;
    }

    private static String bearer(@Nullable String header) {
        if (header == null || !header.regionMatches(true, 0, BEARER, 0, BEARER.length())) {
            throw Rejection.of(
                    AccessProblem.AUTHORIZATION_UNREADABLE,
                    "The Authorization header must be: Bearer, a space, and an access key.");
        }
        return header.substring(BEARER.length()).strip();
    }
}
