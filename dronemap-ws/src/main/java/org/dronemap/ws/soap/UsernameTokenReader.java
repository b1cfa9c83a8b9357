package org.dronemap.ws.soap;

import java.time.Clock;
import java.time.DateTimeException;
import java.time.Duration;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ServerProblem;
import org.dronemap.ws.soap.xml.XmlToJson;
import org.jspecify.annotations.Nullable;
import org.w3c.dom.Element;

/**
 * Reads UsernameTokens with a plain-text password (OASIS UsernameToken Profile 1.1.1) from SOAP headers. One with a
 * nonce is taken once, and only near the time that it says it was made at. Digests cannot be taken: no password is
 * stored here from which one could be made. Any thread.
 */
public final class UsernameTokenReader {
    static final String SECURITY = "http://docs.oasis-open.org/wss/2004/01/oasis-200401-wss-wssecurity-secext-1.0.xsd";
    static final String MADE = "http://docs.oasis-open.org/wss/2004/01/oasis-200401-wss-wssecurity-utility-1.0.xsd";

    private static final String AS_TEXT = "#PasswordText";
    private static final Duration FRESH = Duration.ofMinutes(5);
    /** Whoever sends more within that time has to wait: a forgotten nonce could be sent again. */
    private static final int MOST_REMEMBERED = 100_000;

    private final Clock clock;
    /** When each may be forgotten, the oldest first. */
    private final Map<String, Instant> seen = new LinkedHashMap<>();

    public UsernameTokenReader(Clock clock) {
        this.clock = clock;
    }

    /** {@code password}: as the user types it; {@code nonce}: null, it says nothing of how often it is sent. */
    record Token(String name, String password, @Nullable String nonce) {
        @Override
        public String toString() {
            return "Token of " + name;
        }
    }

    Token read(Element security) {
        Element token = child(security, SECURITY, "UsernameToken");
        Element name = token == null ? null : child(token, SECURITY, "Username");
        Element password = token == null ? null : child(token, SECURITY, "Password");
        if (token == null || name == null || password == null) {
            throw Rejection.of(
                    AccessProblem.AUTHORIZATION_UNREADABLE,
                    "The Security header must have a UsernameToken with a Username and a Password.");
        }
        String type = password.getAttribute("Type");
        if (!type.isEmpty() && !type.endsWith(AS_TEXT)) {
            throw Rejection.of(
                    AccessProblem.AUTHORIZATION_UNREADABLE,
                    "The Password of a UsernameToken must be sent as " + AS_TEXT
                            + "; a digest cannot be compared, as passwords are not stored.");
        }
        Element nonce = child(token, SECURITY, "Nonce");
        Element created = child(token, MADE, "Created");
        if (created != null) {
            requireFresh(time(created.getTextContent().strip()));
        } else if (nonce != null) {
            throw Rejection.of(
                    AccessProblem.AUTHORIZATION_UNREADABLE,
                    "A UsernameToken with a Nonce must say when it was Created.");
        }
        return new Token(
                name.getTextContent().strip(),
                password.getTextContent(),
                nonce == null ? null : nonce.getTextContent().strip());
    }

    private void requireFresh(Instant made) {
        Instant now = clock.instant();
        if (made.isBefore(now.minus(FRESH)) || made.isAfter(now.plus(FRESH))) {
            throw Rejection.of(
                    AccessProblem.TOKEN_STALE,
                    "This UsernameToken was made more than " + FRESH.toMinutes()
                            + " minutes from now by the server's clock; make a new one for each call.");
        }
    }

    /** Of one whose name and password are right: nobody else can fill up what is remembered. */
    synchronized void requireUnused(Token token) {
        String nonce = token.nonce();
        if (nonce == null) {
            return;
        }
        Instant now = clock.instant();
        Iterator<Instant> oldest = seen.values().iterator();
        while (oldest.hasNext() && oldest.next().isBefore(now)) {
            oldest.remove();
        }
        if (seen.size() >= MOST_REMEMBERED) {
            throw Rejection.of(ServerProblem.SERVER_BUSY, "Too many UsernameTokens came lately; try again later.");
        }
        // One that was made the longest allowed time ahead stays fresh for twice that.
        if (seen.putIfAbsent(nonce, now.plus(FRESH.multipliedBy(2))) != null) {
            throw Rejection.of(
                    AccessProblem.TOKEN_USED, "This UsernameToken was used before; make a new nonce for each call.");
        }
    }

    private static Instant time(String text) {
        try {
            return OffsetDateTime.parse(text).toInstant();
        } catch (DateTimeException noTime) {
            throw Rejection.of(
                    AccessProblem.AUTHORIZATION_UNREADABLE,
                    "The Created of a UsernameToken must be a time such as 2026-01-31T12:00:00Z.");
        }
    }

    private static @Nullable Element child(Element element, String namespace, String name) {
        return XmlToJson.children(element).stream()
                .filter(one -> name.equals(one.getLocalName()) && namespace.equals(one.getNamespaceURI()))
                .findFirst()
                .orElse(null);
    }
}
