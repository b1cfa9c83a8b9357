package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import com.nimbusds.jwt.JWTClaimsSet;
import java.net.URI;
import java.nio.file.Path;
import java.time.Instant;
import java.util.Date;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.dronemap.core.access.AccountState;
import org.dronemap.core.access.Role;
import org.dronemap.core.audit.AuditEntry;
import org.dronemap.core.audit.AuditOutcome;
import org.dronemap.ws.security.oidc.OidcSettings;
import org.dronemap.ws.testserver.FakeOidcProvider;
import org.dronemap.ws.testserver.FakeOidcProvider.Signature;
import org.dronemap.ws.testserver.SharedServer;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Signing in with an OpenID Connect provider: who is proved comes in, and nobody else. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class OidcTest {
    private static final String CALLBACK = "/api/v1/session/oidc/callback";

    private FakeOidcProvider provider;
    private TestServer house;
    private TestServer careful;
    private TestHttpClient nobody;
    private TestHttpClient.Answer whileAway;

    @BeforeAll
    void open(@TempDir Path data, @TempDir Path other) {
        provider = new FakeOidcProvider();
        OidcSettings.Roles roles =
                new OidcSettings.Roles("groups", Map.of("pilots", Role.OPERATOR, "office", Role.VIEWER));
        house = new TestServer(data, TestServer.Options.signingInWith(settings(AccountState.ACTIVE, roles)));
        careful = new TestServer(
                other, TestServer.Options.signingInWith(settings(AccountState.WAITING, OidcSettings.Roles.OURS)));
        nobody = new TestHttpClient(house, "");
        // What a provider says of itself is asked for once.
        provider.away(true);
        whileAway = nobody.get("/api/v1/session/oidc");
        provider.away(false);
    }

    @AfterAll
    void close() {
        house.close();
        careful.close();
        provider.close();
    }

    private OidcSettings settings(AccountState accounts, OidcSettings.Roles roles) {
        return new OidcSettings(
                URI.create(provider.issuer()),
                new OidcSettings.Client(FakeOidcProvider.CLIENT, FakeOidcProvider.SECRET),
                URI.create("http://localhost" + CALLBACK),
                "the stand-in",
                accounts,
                roles);
    }

    private static UnaryOperator<JWTClaimsSet.Builder> person(String subject, String... groups) {
        return claims -> claims.subject(subject).claim("groups", List.of(groups));
    }

    /** There and back as a browser does it. */
    private TestHttpClient.Answer signIn(TestHttpClient browser) {
        TestHttpClient.Answer there = browser.get("/api/v1/session/oidc");
        assertThat(there.status()).isEqualTo(302);
        return back(browser, provider.visit(location(there)), cookie(there));
    }

    private static TestHttpClient.Answer back(TestHttpClient browser, String query, String cookie) {
        return browser.send(
                CALLBACK + "?" + query,
                request -> request.header("Cookie", cookie).GET());
    }

    private static URI location(TestHttpClient.Answer answer) {
        return URI.create(answer.raw().headers().firstValue("Location").orElseThrow());
    }

    private static String cookie(TestHttpClient.Answer answer) {
        return answer.raw().headers().allValues("Set-Cookie").stream()
                .map(header -> header.split(";", 2)[0])
                .filter(pair -> !pair.endsWith("="))
                .findFirst()
                .orElse("none=none");
    }

    private static boolean isIn(TestHttpClient browser, TestHttpClient.Answer back) {
        return browser.send(
                                "/api/v1/drones",
                                request ->
                                        request.header("Cookie", cookie(back)).GET())
                        .status()
                == 200;
    }

    @Test
    void asksTheProviderWithStateNonceAndChallenge() {
        TestHttpClient.Answer there = nobody.get("/api/v1/session/oidc");

        assertThat(location(there).toString())
                .startsWith(provider.issuer() + "/authorize?")
                .contains("response_type=code", "state=", "nonce=", "code_challenge_method=S256", "code_challenge=")
                .doesNotContain(FakeOidcProvider.SECRET);
        assertThat(there.raw().headers().firstValue("Set-Cookie").orElse(""))
                .contains("dronemap-oidc=", "HttpOnly", "SameSite=Lax", "Path=/api/v1/session/oidc");
    }

    @Test
    void letsInWhoIsProvedWithTheRoleThatTheClaimGives() {
        provider.says(person("pilot-1", "others", "pilots", "office"));
        TestHttpClient.Answer back = signIn(nobody);

        assertThat(location(back)).hasToString("/");
        assertThat(back.raw().headers().allValues("Set-Cookie").toString()).contains("SameSite=Strict", "HttpOnly");
        TestHttpClient.Answer session = nobody.send(
                "/api/v1/session",
                request -> request.header("Cookie", cookie(back)).GET());
        assertThat(session.text("role")).isEqualTo("operator");
        assertThat(session.text("name")).matches("ann~[0-9a-f]{16}");
    }

    @Test
    void takesARoleAwayWithTheClaimAndFindsTheSameAccount() {
        provider.says(person("pilot-2", "pilots"));
        String before = name(signIn(nobody));
        provider.says(person("pilot-2", "office").andThen(claims -> claims.claim("preferred_username", "anna"))::apply);
        TestHttpClient.Answer back = signIn(nobody);

        assertThat(name(back)).isEqualTo(before);
        assertThat(nobody.send(
                                "/api/v1/session",
                                request ->
                                        request.header("Cookie", cookie(back)).GET())
                        .text("role"))
                .isEqualTo("viewer");
    }

    private String name(TestHttpClient.Answer back) {
        return nobody.send(
                        "/api/v1/session",
                        request -> request.header("Cookie", cookie(back)).GET())
                .text("name");
    }

    @Test
    void doesNotLetInWhomTheClaimGivesNoRole() {
        provider.says(person("stranger", "others"));
        refused(signIn(nobody));
    }

    @Test
    void neverTakesAnAccountByAName() {
        provider.says(claims ->
                claims.subject("evil").claim("preferred_username", "admin").claim("groups", List.of("office")));
        TestHttpClient.Answer back = signIn(nobody);

        assertThat(name(back)).startsWith("admin~");
    }

    @Test
    void makesAnAccountThatWaits() {
        provider.says(person("new one"));
        TestHttpClient browser = new TestHttpClient(careful, "");
        TestHttpClient.Answer back = signIn(browser);

        assertThat(location(back)).hasToString("/?signIn=closed");
        assertThat(isIn(browser, back)).isFalse();
        assertThat(new TestHttpClient(careful, careful.key(Role.ADMINISTRATOR))
                        .get("/api/v1/users")
                        .raw()
                        .body())
                .containsPattern("ann~[0-9a-f]{16}\",\"role\":\"viewer\",\"state\":\"waiting\"");
    }

    static Stream<Arguments> wrongClaims() {
        Date past = Date.from(Instant.now().minusSeconds(600));
        return Stream.of(
                Arguments.of("another issuer", change(claims -> claims.issuer("https://evil.example"))),
                Arguments.of("another audience", change(claims -> claims.audience("another-client"))),
                Arguments.of("another nonce", change(claims -> claims.claim("nonce", "of another sign-in"))),
                Arguments.of("no nonce", change(claims -> claims.claim("nonce", null))),
                Arguments.of("expired", change(claims -> claims.expirationTime(past))),
                Arguments.of("no end", change(claims -> claims.expirationTime(null))),
                Arguments.of("nobody", change(claims -> claims.subject(null))));
    }

    private static UnaryOperator<JWTClaimsSet.Builder> change(UnaryOperator<JWTClaimsSet.Builder> change) {
        return claims -> change.apply(claims.claim("groups", List.of("office")));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("wrongClaims")
    void refusesATokenWithWrongClaims(String what, UnaryOperator<JWTClaimsSet.Builder> claims) {
        provider.says(claims);
        refused(signIn(nobody));
    }

    @ParameterizedTest
    @EnumSource(mode = EnumSource.Mode.EXCLUDE, names = "OWN_KEY")
    void refusesATokenThatTheProvidersKeyDidNotSign(Signature signature) {
        provider.says(person("pilot-1", "office"));
        provider.signsWith(signature);
        refused(signIn(nobody));
    }

    @Test
    void refusesACodeASecondTime() {
        provider.says(person("pilot-1", "office"));
        TestHttpClient.Answer there = nobody.get("/api/v1/session/oidc");
        String query = provider.visit(location(there));
        assertThat(isIn(nobody, back(nobody, query, cookie(there)))).isTrue();

        refused(back(nobody, query, cookie(there)));
        TestHttpClient.Answer again = nobody.get("/api/v1/session/oidc");
        String state = location(again).getRawQuery().replaceFirst(".*state=([^&]+).*", "$1");
        refused(back(nobody, query.replaceFirst("state=.*", "state=" + state), cookie(again)));
    }

    @Test
    void refusesAnswersToWhatAnotherBrowserBegan() {
        provider.says(person("pilot-1", "office"));
        String mine = provider.visit(location(nobody.get("/api/v1/session/oidc")));

        refused(back(nobody, mine, cookie(nobody.get("/api/v1/session/oidc"))));
        refused(back(nobody, "code=made-up&state=made-up", "none=none"));
        refused(back(nobody, "error=access_denied", "none=none"));
    }

    @Test
    void saysThatTheProviderCannotBeAsked() {
        assertThat(whileAway.status()).isEqualTo(503);
        assertThat(whileAway.text("code")).isEqualTo("provider-unreachable");
    }

    private void refused(TestHttpClient.Answer back) {
        assertThat(back.status()).isEqualTo(302);
        assertThat(location(back)).hasToString("/?signIn=failed");
        AuditEntry record = house.records().get(house.records().size() - 1).entry();
        assertThat(record.operation()).isEqualTo("GET " + CALLBACK);
        assertThat(record.outcome()).isEqualTo(AuditOutcome.REFUSED);
        assertThat(back.raw().headers().allValues("Set-Cookie").toString()).doesNotContain("dronemap-session");
        assertThat(back.raw().body()).doesNotContain(FakeOidcProvider.SECRET);
    }

    @Test
    void tellsThePageOfTheProviderOnlyWhereThereIsOne() {
        assertThat(nobody.get("/api/v1/registrations").text("signInWith")).isEqualTo("the stand-in");
        TestHttpClient browser = new TestHttpClient(SharedServer.get(), "");
        assertThat(browser.get("/api/v1/registrations")
                        .json()
                        .path("signInWith")
                        .isNull())
                .isTrue();
        assertThat(browser.get("/api/v1/session/oidc").status()).isEqualTo(404);
        assertThat(browser.get(CALLBACK).status()).isEqualTo(404);
    }
}
