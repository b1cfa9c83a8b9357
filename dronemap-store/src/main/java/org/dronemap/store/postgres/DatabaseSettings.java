package org.dronemap.store.postgres;

import java.net.URI;
import java.net.URISyntaxException;
import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.regex.Pattern;
import org.dronemap.store.StoreException;
import org.jspecify.annotations.Nullable;

/**
 * Connection settings of a PostgreSQL database.
 *
 * @param jdbcUrl without user and password when those were split off
 * @param user null when the URL's query carries it
 * @param password null when the URL's query carries it, or when none is needed
 * @param patience how long a database that does not answer is waited for
 */
public record DatabaseSettings(
        String jdbcUrl, @Nullable String user, @Nullable String password, Duration patience) {
    private static final Pattern URI_FORM = Pattern.compile("postgres(ql)?://.*");
    private static final Pattern JDBC_FORM = Pattern.compile("jdbc:postgresql:.*");
    private static final Duration DEFAULT_WAIT = Duration.ofSeconds(30);

    /**
     * From {@code jdbc:postgresql://host:5432/name?user=u&password=p} or {@code postgresql://u:p@host:5432/name};
     * the sentence of a refusal never repeats the URL, for it may hold a password.
     */
    public static DatabaseSettings of(String url) {
        String trimmed = url.strip();
        if (JDBC_FORM.matcher(trimmed).matches() && trimmed.indexOf('@') < 0) {
            return new DatabaseSettings(trimmed, null, null, DEFAULT_WAIT);
        }
        String plain = trimmed.startsWith("jdbc:") ? trimmed.substring("jdbc:".length()) : trimmed;
        if (!URI_FORM.matcher(plain).matches()) {
            throw refused(null);
        }
        return ofUri(plain);
    }

    public DatabaseSettings withPatience(Duration next) {
        return new DatabaseSettings(jdbcUrl, user, password, next);
    }

    private static DatabaseSettings ofUri(String plain) {
        URI uri;
        try {
            uri = new URI(plain);
        } catch (URISyntaxException e) {
            throw refused(e.getReason());
        }
        if (uri.getHost() == null || uri.getRawPath().length() < 2) {
            throw refused(null);
        }
        String port = uri.getPort() < 0 ? "" : ":" + uri.getPort();
        String query = uri.getRawQuery() == null ? "" : "?" + uri.getRawQuery();
        String jdbcUrl = "jdbc:postgresql://" + uri.getHost() + port + uri.getRawPath() + query;
        String login = uri.getRawUserInfo();
        if (login == null) {
            return new DatabaseSettings(jdbcUrl, null, null, DEFAULT_WAIT);
        }
        int colon = login.indexOf(':');
        String user = decoded(colon < 0 ? login : login.substring(0, colon));
        return new DatabaseSettings(
                jdbcUrl, user, colon < 0 ? null : decoded(login.substring(colon + 1)), DEFAULT_WAIT);
    }

    private static String decoded(String part) {
        // A plus sign is itself in this part of a URL.
        return URLDecoder.decode(part.replace("+", "%2B"), StandardCharsets.UTF_8);
    }

    private static StoreException refused(@Nullable String why) {
        return new StoreException("The database URL is not of the form postgresql://user:password@host:5432/name or "
                + "jdbc:postgresql://host:5432/name?user=…&password=…" + (why == null ? "." : ": " + why + "."));
    }

    /** Without the password. */
    @Override
    public String toString() {
        return jdbcUrl.replaceAll("(?i)(password=)[^&]*", "$1***");
    }
}
