package org.dronemap.ws.access;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import org.springframework.boot.webmvc.error.ErrorController;
import org.springframework.web.method.HandlerMethod;
import org.springframework.web.servlet.HandlerInterceptor;

/**
 * Fails a REST request that Spring dispatches to another handler than that whose {@link Access} the filters checked.
 * They find it by themselves, before the dispatcher does; should the two ever differ, the request fails instead of
 * being carried out unjudged.
 */
public final class HandlerMatchInterceptor implements HandlerInterceptor {
    private final RestOperations operations;

    public HandlerMatchInterceptor(RestOperations operations) {
        this.operations = operations;
    }

    @Override
    public boolean preHandle(HttpServletRequest request, HttpServletResponse response, Object handler) {
        Access access = handler instanceof HandlerMethod method && !handlesErrors(method)
                ? method.getMethodAnnotation(Access.class)
                : null;
        if (access != null) {
            RestOperation judged = operations.rule(request).operation();
            if (judged == null || !judged.access().equals(access)) {
                throw new IllegalStateException("A request was judged as one for "
                        + (judged == null ? "nothing" : judged.name()) + ", and dispatched to " + handler);
            }
        }
        return true;
    }

    /** It carries nothing out, and comes after the handler that was judged: not always by a dispatch of its own type. */
    private static boolean handlesErrors(HandlerMethod method) {
        return ErrorController.class.isAssignableFrom(method.getBeanType());
    }
}
