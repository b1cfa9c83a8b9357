package org.dronemap.ws.security;

import jakarta.servlet.http.Cookie;
import jakarta.servlet.http.HttpServletRequest;
import java.time.Duration;
import java.util.Arrays;
import java.util.Optional;
import org.springframework.http.ResponseCookie;

/** The cookie that carries a session's token. */
public final class SessionCookie {
    static final String NAME = "dronemap-session";

    private SessionCookie() {}

    /** The header value that hands it out. */
    public static String issue(String token, boolean secure) {
        return build(token, secure, CallerAuthenticator.SESSION_LENGTH);
    }

    /** The header value that takes it back. */
    public static String clear(boolean secure) {
        return build("", secure, Duration.ZERO);
    }

    static Optional<String> read(HttpServletRequest request) {
        Cookie[] cookies = request.getCookies();
        return cookies == null
                ? Optional.empty()
                : Arrays.stream(cookies)
                        .filter(cookie -> cookie.getName().equals(NAME))
                        .map(Cookie::getValue)
                        .filter(value -> !value.isEmpty())
                        .findFirst();
    }

    private static String build(String token, boolean secure, Duration length) {
        return ResponseCookie.from(NAME, token)
                .httpOnly(true)
                .secure(secure)
                .sameSite("Strict")
                .path("/")
                .maxAge(length)
                .build()
                .toString();
    }
}
