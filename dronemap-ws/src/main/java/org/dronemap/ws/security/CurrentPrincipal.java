package org.dronemap.ws.security;

import jakarta.servlet.ServletRequest;
import java.util.Optional;
import org.dronemap.core.access.Principal;
import org.dronemap.ws.service.Rejection;
import org.springframework.web.context.request.RequestAttributes;
import org.springframework.web.context.request.RequestContextHolder;

/** Who asks in the request that this thread serves. */
public final class CurrentPrincipal {
    private static final String ATTRIBUTE = Caller.class.getName();

    /** The caller, or a 401. */
    public Caller caller() {
        RequestAttributes request = RequestContextHolder.currentRequestAttributes();
        return Optional.ofNullable(request.getAttribute(ATTRIBUTE, RequestAttributes.SCOPE_REQUEST))
                .map(Caller.class::cast)
                .orElseThrow(() -> Rejection.notSignedIn("Sign in first, or send an access key."));
    }

    public Principal principal() {
        return caller().principal();
    }

    /** The name of the face in the command log: a session is somebody at the page. */
    public String face() {
        return caller().proof() == Caller.Proof.SESSION ? "page" : "rest";
    }

    static void set(ServletRequest request, Caller caller) {
        request.setAttribute(ATTRIBUTE, caller);
    }
}
