package org.dronemap.ws.security;

import jakarta.servlet.ServletRequest;
import java.util.Optional;
import org.dronemap.core.access.Principal;
import org.dronemap.ws.access.Caller;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.Rejection;
import org.springframework.web.context.request.RequestAttributes;
import org.springframework.web.context.request.RequestContextHolder;

/** Gives REST handlers the authenticated caller of the request that the current thread serves. */
public final class CurrentPrincipal {
    private static final String ATTRIBUTE = AuthenticatedCaller.class.getName();
    private static final String OTHER_FACE = ForwardedCaller.class.getName();

    /** Who signed in, or a 401. */
    public AuthenticatedCaller signedIn() {
        RequestAttributes request = RequestContextHolder.currentRequestAttributes();
        return Optional.ofNullable(request.getAttribute(ATTRIBUTE, RequestAttributes.SCOPE_REQUEST))
                .map(AuthenticatedCaller.class::cast)
                .orElseThrow(() -> Rejection.of(AccessProblem.SIGN_IN_NEEDED, "Sign in first, or send an access key."));
    }

    /** A 401 for strangers; what may be looked at by everybody who is signed in asks for no more. */
    public void requireSignedIn() {
        signedIn();
    }

    public Principal principal() {
        return signedIn().principal();
    }

    public Caller caller() {
        return new Caller(principal(), face());
    }

    /** The name of the face in the command log: a session is somebody at the page. */
    public String face() {
        RequestAttributes request = RequestContextHolder.currentRequestAttributes();
        if (request.getAttribute(OTHER_FACE, RequestAttributes.SCOPE_REQUEST) instanceof ForwardedCaller other) {
            return other.face();
        }
        return signedIn().proof() == AuthenticatedCaller.Proof.SESSION ? "page" : "rest";
    }

    /** Only this program sets attributes: no client can say that it came by another face. */
    public static void from(ServletRequest request, ForwardedCaller other) {
        request.setAttribute(OTHER_FACE, other);
    }

    /** The other face that it came by; empty: REST. */
    public static Optional<ForwardedCaller> otherFace(ServletRequest request) {
        return Optional.ofNullable(request.getAttribute(OTHER_FACE)).map(ForwardedCaller.class::cast);
    }

    static void set(ServletRequest request, AuthenticatedCaller signedIn) {
        request.setAttribute(ATTRIBUTE, signedIn);
    }
}
