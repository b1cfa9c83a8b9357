package org.dronemap.ws.soap;

import jakarta.servlet.http.HttpServletRequest;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.apache.cxf.headers.Header;
import org.apache.cxf.message.Message;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.security.AuthenticatedCaller;
import org.dronemap.ws.security.CallerAuthenticator;
import org.dronemap.ws.security.ForwardedCaller;
import org.dronemap.ws.soap.xml.SoapNamespaces;
import org.jspecify.annotations.Nullable;
import org.w3c.dom.Element;

/** Authenticates the caller by HTTP Basic, a bearer key, the header accessKey or a UsernameToken. Any thread. */
public final class SoapAuthentication {
    private static final String FACE = "soap";
    private static final String WAYS =
            "Send an access key (Authorization: Bearer KEY, or the SOAP header accessKey), or name and password by HTTP"
                    + " Basic or as UsernameToken.";

    private final CallerAuthenticator authentication;
    private final UsernameTokenReader tokens;

    public SoapAuthentication(CallerAuthenticator authentication, UsernameTokenReader tokens) {
        this.authentication = authentication;
        this.tokens = tokens;
    }

    /** What the message says is read now, and judged only when it has to be known who calls. */
    ForwardedCaller of(Message message, HttpServletRequest request) {
        return new ForwardedCaller(FACE, new ProofOnce(proof(message, request)));
    }

    private Supplier<AuthenticatedCaller> proof(Message message, HttpServletRequest request) {
        String authorization = request.getHeader("Authorization");
        String address = request.getRemoteAddr();
        if (authorization != null) {
            return () -> byHttp(authorization, address);
        }
        Optional<Element> key = header(message, SoapNamespaces.URI, "accessKey");
        if (key.isPresent()) {
            return () -> authentication.byKey(key.get().getTextContent().strip());
        }
        Optional<Element> security = header(message, UsernameTokenReader.SECURITY, "Security");
        return () -> security.map(tokens::read)
                .map(token -> byToken(token, address))
                .orElseThrow(() -> Rejection.of(AccessProblem.SIGN_IN_NEEDED, WAYS));
    }

    private AuthenticatedCaller byToken(UsernameTokenReader.Token token, String address) {
        AuthenticatedCaller caller = authentication.byPassword(token.name(), token.password(), address);
        tokens.requireUnused(token);
        return caller;
    }

    /** A call may make a second request, for the outcome of a command that was refused; it is proved by the same message. */
    private static final class ProofOnce implements Supplier<AuthenticatedCaller> {
        private final Supplier<AuthenticatedCaller> proof;
        private @Nullable AuthenticatedCaller proved;

        ProofOnce(Supplier<AuthenticatedCaller> proof) {
            this.proof = proof;
        }

        @Override
        public synchronized AuthenticatedCaller get() {
            AuthenticatedCaller caller = proved;
            if (caller == null) {
                caller = proof.get();
                proved = caller;
            }
            return caller;
        }
    }

    private AuthenticatedCaller byHttp(String authorization, String address) {
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

    private static Optional<Element> header(Message message, String namespace, String name) {
        if (!(message.get(Header.HEADER_LIST) instanceof List<?> headers)) {
            return Optional.empty();
        }
        return headers.stream()
                .filter(Header.class::isInstance)
                .map(Header.class::cast)
                .filter(header -> header.getName().getNamespaceURI().equals(namespace)
                        && header.getName().getLocalPart().equals(name))
                .map(Header::getObject)
                .filter(Element.class::isInstance)
                .map(Element.class::cast)
                .findFirst();
    }
}
