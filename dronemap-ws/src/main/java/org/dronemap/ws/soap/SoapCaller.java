package org.dronemap.ws.soap;

import jakarta.servlet.http.HttpServletRequest;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.List;
import java.util.Optional;
import org.apache.cxf.headers.Header;
import org.apache.cxf.message.Message;
import org.apache.cxf.phase.PhaseInterceptorChain;
import org.apache.cxf.transport.http.AbstractHTTPDestination;
import org.dronemap.core.access.Principal;
import org.dronemap.ws.security.Authentication;
import org.dronemap.ws.security.SignedIn;
import org.dronemap.ws.service.AccessProblem;
import org.dronemap.ws.service.Budgets;
import org.dronemap.ws.service.Rejection;
import org.dronemap.ws.service.Work;
import org.w3c.dom.Element;

/** Who calls: by HTTP Basic, by a bearer key, or by the SOAP header element {@code accessKey}. */
public final class SoapCaller {
    private static final String WAYS =
            "Send an access key (Authorization: Bearer KEY, or the SOAP header accessKey), or name and password by HTTP"
                    + " Basic.";

    private final Authentication authentication;
    private final Budgets budgets;

    public SoapCaller(Authentication authentication, Budgets budgets) {
        this.authentication = authentication;
        this.budgets = budgets;
    }

    /** Whoever asks for more than a budget allows is refused. */
    Principal reading() {
        Principal principal = principal();
        budgets.take(Work.REQUEST, principal.name());
        return principal;
    }

    /** For what tells drones something: commands have a budget of their own, control has none. */
    Principal principal() {
        Message message = PhaseInterceptorChain.getCurrentMessage();
        if (!(message.get(AbstractHTTPDestination.HTTP_REQUEST) instanceof HttpServletRequest request)) {
            throw new IllegalStateException("a SOAP call came without an HTTP request");
        }
        String authorization = request.getHeader("Authorization");
        SignedIn caller = authorization == null
                ? accessKey(message)
                        .map(authentication::byKey)
                        .orElseThrow(() -> Rejection.of(AccessProblem.SIGN_IN_NEEDED, WAYS))
                : byHttp(authorization, request.getRemoteAddr());
        authentication.admit(caller);
        return caller.principal();
    }

    private SignedIn byHttp(String authorization, String address) {
        String[] parts = authorization.strip().split("\\s+", 2);
        if (parts.length == 2 && parts[0].equalsIgnoreCase("Bearer")) {
            return authentication.byKey(parts[1]);
        }
        if (parts.length != 2 || !parts[0].equalsIgnoreCase("Basic")) {
            throw Rejection.of(AccessProblem.AUTHORIZATION_UNREADABLE, WAYS);
        }
        String credentials = decode(parts[1]);
        int colon = credentials.indexOf(':');
        if (colon < 0) {
            throw Rejection.of(AccessProblem.AUTHORIZATION_UNREADABLE, WAYS);
        }
        return authentication.byPassword(credentials.substring(0, colon), credentials.substring(colon + 1), address);
    }

    private static String decode(String base64) {
        try {
            return new String(Base64.getDecoder().decode(base64), StandardCharsets.UTF_8);
        } catch (IllegalArgumentException notBase64) {
            throw Rejection.of(AccessProblem.AUTHORIZATION_UNREADABLE, WAYS);
        }
    }

    private static Optional<String> accessKey(Message message) {
        if (!(message.get(Header.HEADER_LIST) instanceof List<?> headers)) {
            return Optional.empty();
        }
        return headers.stream()
                .filter(Header.class::isInstance)
                .map(Header.class::cast)
                .filter(header -> Namespace.URI.equals(header.getName().getNamespaceURI()))
                .filter(header -> header.getName().getLocalPart().equals("accessKey"))
                .map(Header::getObject)
                .filter(Element.class::isInstance)
                .map(element -> ((Element) element).getTextContent().strip())
                .findFirst();
    }
}
