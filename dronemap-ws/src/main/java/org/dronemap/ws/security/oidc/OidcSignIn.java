package org.dronemap.ws.security.oidc;

import com.nimbusds.openid.connect.sdk.claims.IDTokenClaimsSet;
import java.net.URI;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.User;
import org.dronemap.ws.account.ExternalUsers;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ServerProblem;
import org.dronemap.ws.reading.SecretGenerator;
import org.dronemap.ws.security.CallerAuthenticator;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Signs users in by an OpenID Connect provider, with PKCE, state and nonce, in the browser that began within 10 min.
 * Any thread.
 */
public final class OidcSignIn {
    private static final Logger LOG = LoggerFactory.getLogger(OidcSignIn.class);
    private static final Duration LONGEST = Duration.ofMinutes(10);
    private static final int MOST_BEGUN = 10_000;

    private final OidcSettings settings;
    private final OidcProvider provider;
    private final CallerAuthenticator authentication;
    private final ExternalUsers users;
    private final Clock clock;
    private final SecretGenerator secrets = new SecretGenerator();

    /** Guarded by this: by state; the eldest goes when it is full. */
    private final Map<String, PendingSignIn> begun = new LinkedHashMap<>() {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, PendingSignIn> eldest) {
            return size() > MOST_BEGUN;
        }
    };

    private record PendingSignIn(OidcProvider.Secrets secrets, String browserHash, Instant until) {}

    /** Redirect of the browser to the provider, and the value that it has to keep for the callback. */
    public record SignInRedirect(URI address, String browser) {}

    /** Parameters with which the browser returns from the provider. */
    public record SignInCallback(
            @Nullable String code,
            @Nullable String state,
            @Nullable String browser) {}

    public OidcSignIn(OidcSettings settings, CallerAuthenticator authentication, ExternalUsers users, Clock clock) {
        this.settings = settings;
        this.provider = new OidcProvider(settings);
        this.authentication = authentication;
        this.users = users;
        this.clock = clock;
    }

    /** What the page's button names. */
    public String label() {
        return settings.label();
    }

    public SignInRedirect start() {
        OidcProvider.Secrets fresh = OidcProvider.Secrets.random();
        String browser = secrets.token();
        try {
            URI address = provider.signInAddress(fresh);
            remember(fresh, browser);
            return new SignInRedirect(address, browser);
        } catch (OidcSignInException e) {
            LOG.warn("Nobody can sign in with {}: {}", settings.label(), e.getMessage());
            throw Rejection.of(
                    ServerProblem.PROVIDER_UNREACHABLE,
                    settings.label() + " cannot be asked at the moment; try again later.",
                    ProblemParameter.PROVIDER.is(settings.label()));
        }
    }

    private synchronized void remember(OidcProvider.Secrets fresh, String browser) {
        Instant now = clock.instant();
        begun.values().removeIf(one -> !one.until().isAfter(now));
        begun.put(fresh.state().getValue(), new PendingSignIn(fresh, SecretGenerator.hash(browser), now.plus(LONGEST)));
    }

    /**
     * Ends what {@link #start} began, with a session.
     *
     * @throws Rejection when nothing is proved, or the account may not sign in
     */
    public CallerAuthenticator.NewSession finish(SignInCallback back) {
        try {
            PendingSignIn start = redeem(back);
            String code = back.code();
            if (code == null) {
                throw new OidcSignInException("the provider sent no code");
            }
            IDTokenClaimsSet claims = provider.prove(code, start.secrets());
            User user = users.admit(
                    new ExternalUsers.Identity(
                            claims.getIssuer().getValue(), claims.getSubject().getValue(), name(claims), role(claims)),
                    settings.newAccounts());
            return authentication.signInProved(user);
        } catch (OidcSignInException e) {
            LOG.warn("A sign-in with {} was refused: {}", settings.label(), e.getMessage());
            throw Rejection.of(
                    AccessProblem.PROVIDER_SIGN_IN_FAILED,
                    "The sign-in with " + settings.label() + " was not successful; try again.",
                    ProblemParameter.PROVIDER.is(settings.label()));
        }
    }

    private synchronized PendingSignIn redeem(SignInCallback back) throws OidcSignInException {
        PendingSignIn start = back.state() == null ? null : begun.remove(back.state());
        if (start == null || !start.until().isAfter(clock.instant())) {
            throw new OidcSignInException("it was not begun here, took too long, or was ended already");
        }
        if (back.browser() == null || !start.browserHash().equals(SecretGenerator.hash(back.browser()))) {
            throw new OidcSignInException("another browser began it");
        }
        return start;
    }

    private static @Nullable String name(IDTokenClaimsSet claims) {
        return Stream.of("preferred_username", "name", "email")
                .map(claims::getStringClaim)
                .filter(value -> value != null && !value.isBlank())
                .findFirst()
                .orElse(null);
    }

    /** The highest that the claim gives; null where roles are given here. */
    private @Nullable Role role(IDTokenClaimsSet claims) throws OidcSignInException {
        String claim = settings.roles().claim();
        if (claim == null) {
            return null;
        }
        Object value = claims.getClaim(claim);
        List<?> values = value instanceof List<?> many ? many : value == null ? List.of() : List.of(value);
        Optional<Role> highest = values.stream()
                .map(one -> settings.roles().byValue().get(String.valueOf(one)))
                .filter(java.util.Objects::nonNull)
                .max(Comparator.naturalOrder());
        return highest.orElseThrow(() -> new OidcSignInException("the claim " + claim + " gives none of the roles"));
    }
}
