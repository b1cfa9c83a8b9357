package org.dronemap.ws.testserver;

import com.nimbusds.jose.JOSEException;
import com.nimbusds.jose.JWSAlgorithm;
import com.nimbusds.jose.JWSHeader;
import com.nimbusds.jose.crypto.MACSigner;
import com.nimbusds.jose.crypto.RSASSASigner;
import com.nimbusds.jose.jwk.JWKSet;
import com.nimbusds.jose.jwk.RSAKey;
import com.nimbusds.jose.jwk.gen.RSAKeyGenerator;
import com.nimbusds.jwt.JWTClaimsSet;
import com.nimbusds.jwt.PlainJWT;
import com.nimbusds.jwt.SignedJWT;
import java.net.URI;
import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.Instant;
import java.util.Base64;
import java.util.Date;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.UnaryOperator;

/** An OpenID Connect provider on this machine: everybody who comes is signed in, with the claims that the test says. */
public final class FakeOidcProvider implements AutoCloseable {
    public static final String CLIENT = "dronemap";
    public static final String SECRET = "canary-of-the-client-secret";

    private volatile boolean away;
    private final StubHttpServer server;
    private final RSAKey key;
    private final Map<String, Map<String, String>> asked = new ConcurrentHashMap<>();
    private final AtomicInteger codes = new AtomicInteger();
    private volatile UnaryOperator<JWTClaimsSet.Builder> claims = builder -> builder;
    private volatile Signature signature = Signature.OWN_KEY;

    /** What the token is signed with. */
    public enum Signature {
        OWN_KEY,
        ANOTHER_KEY,
        SHARED_SECRET,
        NONE
    }

    public FakeOidcProvider() {
        try {
            key = new RSAKeyGenerator(2048).keyID("one").generate();
        } catch (JOSEException e) {
            throw new IllegalStateException(e);
        }
        server = new StubHttpServer(this::answer);
    }

    private StubHttpServer.Answer answer(StubHttpServer.Request request) {
        if (away) {
            return new StubHttpServer.Answer(503, "{}");
        }
        return switch (request.path()) {
            case "/.well-known/openid-configuration" -> new StubHttpServer.Answer(200, """
                    {"issuer":"%1$s","authorization_endpoint":"%1$s/authorize","token_endpoint":"%1$s/token",
                     "jwks_uri":"%1$s/keys","response_types_supported":["code"],"subject_types_supported":["public"],
                     "id_token_signing_alg_values_supported":["RS256"]}""".formatted(issuer()));
            case "/keys" -> new StubHttpServer.Answer(200, new JWKSet(key.toPublicJWK()).toString());
            case "/token" -> token(request);
            default -> new StubHttpServer.Answer(404, "{}");
        };
    }

    /** Whether it has nothing to say from now on. */
    public void away(boolean isAway) {
        away = isAway;
    }

    public String issuer() {
        return "http://127.0.0.1:" + server.port();
    }

    /** What the next tokens say otherwise. */
    public void says(UnaryOperator<JWTClaimsSet.Builder> change) {
        claims = change;
        signature = Signature.OWN_KEY;
    }

    public void signsWith(Signature with) {
        signature = with;
    }

    /** What a person's browser is sent back with, having signed in at that address: the query. */
    public String visit(URI address) {
        Map<String, String> query = form(address.getRawQuery());
        String code = "code-" + codes.incrementAndGet();
        asked.put(code, query);
        return "code=" + code + "&state=" + query.get("state");
    }

    private StubHttpServer.Answer token(StubHttpServer.Request request) {
        Map<String, String> form = form(request.body());
        // each code serves once
        Map<String, String> query = asked.remove(form.getOrDefault("code", ""));
        String basic =
                "Basic " + Base64.getEncoder().encodeToString((CLIENT + ":" + SECRET).getBytes(StandardCharsets.UTF_8));
        if (query == null
                || !basic.equals(request.headers().get("authorization"))
                || !query.get("redirect_uri").equals(form.get("redirect_uri"))
                || !query.get("code_challenge").equals(challenge(form.getOrDefault("code_verifier", "")))) {
            return new StubHttpServer.Answer(400, "{\"error\":\"invalid_grant\"}");
        }
        return new StubHttpServer.Answer(
                200,
                "{\"access_token\":\"a\",\"token_type\":\"Bearer\",\"id_token\":\"" + idToken(query.get("nonce"))
                        + "\"}");
    }

    private String idToken(String nonce) {
        Instant now = Instant.now();
        JWTClaimsSet set = claims.apply(new JWTClaimsSet.Builder()
                        .issuer(issuer())
                        .audience(CLIENT)
                        .subject("subject-1")
                        .claim("nonce", nonce)
                        .claim("preferred_username", "ann")
                        .issueTime(Date.from(now))
                        .expirationTime(Date.from(now.plusSeconds(300))))
                .build();
        try {
            return switch (signature) {
                case NONE -> new PlainJWT(set).serialize();
                case SHARED_SECRET -> {
                    SignedJWT token = new SignedJWT(new JWSHeader(JWSAlgorithm.HS256), set);
                    token.sign(new MACSigner(
                            (SECRET + "-and-some-more-of-it-to-be-long").getBytes(StandardCharsets.UTF_8)));
                    yield token.serialize();
                }
                case ANOTHER_KEY ->
                    signed(set, new RSAKeyGenerator(2048).keyID("one").generate());
                case OWN_KEY -> signed(set, key);
            };
        } catch (JOSEException e) {
            throw new IllegalStateException(e);
        }
    }

    private static String signed(JWTClaimsSet set, RSAKey with) throws JOSEException {
        SignedJWT token = new SignedJWT(
                new JWSHeader.Builder(JWSAlgorithm.RS256).keyID("one").build(), set);
        token.sign(new RSASSASigner(with));
        return token.serialize();
    }

    private static String challenge(String verifier) {
        try {
            byte[] hash = MessageDigest.getInstance("SHA-256").digest(verifier.getBytes(StandardCharsets.US_ASCII));
            return Base64.getUrlEncoder().withoutPadding().encodeToString(hash);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }

    private static Map<String, String> form(String text) {
        Map<String, String> form = new LinkedHashMap<>();
        for (String pair : text.split("&", -1)) {
            String[] parts = pair.split("=", 2);
            form.put(parts[0], URLDecoder.decode(parts.length > 1 ? parts[1] : "", StandardCharsets.UTF_8));
        }
        return form;
    }

    @Override
    public void close() {
        server.close();
    }
}
