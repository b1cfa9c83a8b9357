package org.dronemap.ws.security.oidc;

import com.nimbusds.jose.JWSAlgorithm;
import com.nimbusds.jose.jwk.source.JWKSource;
import com.nimbusds.jose.jwk.source.JWKSourceBuilder;
import com.nimbusds.jose.proc.BadJOSEException;
import com.nimbusds.jose.proc.JWSVerificationKeySelector;
import com.nimbusds.jose.proc.SecurityContext;
import com.nimbusds.jose.util.DefaultResourceRetriever;
import com.nimbusds.jwt.JWT;
import com.nimbusds.oauth2.sdk.AuthorizationCode;
import com.nimbusds.oauth2.sdk.AuthorizationCodeGrant;
import com.nimbusds.oauth2.sdk.GeneralException;
import com.nimbusds.oauth2.sdk.ResponseType;
import com.nimbusds.oauth2.sdk.Scope;
import com.nimbusds.oauth2.sdk.TokenRequest;
import com.nimbusds.oauth2.sdk.TokenResponse;
import com.nimbusds.oauth2.sdk.auth.ClientAuthenticationMethod;
import com.nimbusds.oauth2.sdk.auth.ClientSecretBasic;
import com.nimbusds.oauth2.sdk.auth.ClientSecretPost;
import com.nimbusds.oauth2.sdk.auth.Secret;
import com.nimbusds.oauth2.sdk.http.HTTPRequest;
import com.nimbusds.oauth2.sdk.id.ClientID;
import com.nimbusds.oauth2.sdk.id.Issuer;
import com.nimbusds.oauth2.sdk.id.State;
import com.nimbusds.oauth2.sdk.pkce.CodeChallengeMethod;
import com.nimbusds.oauth2.sdk.pkce.CodeVerifier;
import com.nimbusds.openid.connect.sdk.AuthenticationRequest;
import com.nimbusds.openid.connect.sdk.Nonce;
import com.nimbusds.openid.connect.sdk.OIDCTokenResponse;
import com.nimbusds.openid.connect.sdk.OIDCTokenResponseParser;
import com.nimbusds.openid.connect.sdk.claims.IDTokenClaimsSet;
import com.nimbusds.openid.connect.sdk.op.OIDCProviderMetadata;
import com.nimbusds.openid.connect.sdk.validators.IDTokenValidator;
import java.io.IOException;
import java.net.URI;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * Client of an OpenID Connect provider: makes the sign-in address, and verifies the ID token that comes back. Any
 * thread.
 */
final class OidcProvider {
    private static final int PATIENCE_MILLIS = 5_000;
    private static final int LARGEST_KEYS_BYTES = 256 * 1024;
    /** What proves something: no shared secret, and never none at all. */
    private static final Set<JWSAlgorithm> SIGNATURES = Set.of(
            JWSAlgorithm.RS256,
            JWSAlgorithm.RS384,
            JWSAlgorithm.RS512,
            JWSAlgorithm.PS256,
            JWSAlgorithm.PS384,
            JWSAlgorithm.PS512,
            JWSAlgorithm.ES256,
            JWSAlgorithm.ES384,
            JWSAlgorithm.ES512);

    private final OidcSettings settings;
    private final ClientID client;
    private volatile @Nullable ProviderConfiguration known;

    /** Metadata and ID-token validator of the provider; its keys are fetched again when one is not among them. */
    private record ProviderConfiguration(OIDCProviderMetadata metadata, IDTokenValidator validator) {}

    /** Random values of one sign-in that the callback is verified with: state, nonce and PKCE code verifier. */
    record Secrets(State state, Nonce nonce, CodeVerifier verifier) {
        static Secrets random() {
            return new Secrets(new State(), new Nonce(), new CodeVerifier());
        }
    }

    OidcProvider(OidcSettings settings) {
        this.settings = settings;
        this.client = new ClientID(settings.client().id());
    }

    URI signInAddress(Secrets secrets) throws OidcSignInException {
        return new AuthenticationRequest.Builder(
                        ResponseType.CODE, new Scope("openid", "profile", "email"), client, settings.callback())
                .endpointURI(known().metadata().getAuthorizationEndpointURI())
                .state(secrets.state())
                .nonce(secrets.nonce())
                .codeChallenge(secrets.verifier(), CodeChallengeMethod.S256)
                .build()
                .toURI();
    }

    /** Exchanges the code; issuer, audience, signature, times and nonce of the answer are right. */
    IDTokenClaimsSet prove(String code, Secrets secrets) throws OidcSignInException {
        ProviderConfiguration provider = known();
        try {
            HTTPRequest request =
                    tokenRequest(provider.metadata(), code, secrets).toHTTPRequest();
            request.setConnectTimeout(PATIENCE_MILLIS);
            request.setReadTimeout(PATIENCE_MILLIS);
            request.setFollowRedirects(false);
            TokenResponse response = OIDCTokenResponseParser.parse(request.send());
            if (!(response instanceof OIDCTokenResponse success)) {
                throw new OidcSignInException("the provider did not take the code ("
                        + response.toErrorResponse().getErrorObject().getCode() + ")");
            }
            JWT token = success.getOIDCTokens().getIDToken();
            return provider.validator().validate(token, secrets.nonce());
        } catch (GeneralException | IOException e) {
            throw new OidcSignInException("the provider's answer cannot be used", e);
        } catch (BadJOSEException | com.nimbusds.jose.JOSEException e) {
            throw new OidcSignInException("the provider's answer proves nothing", e);
        }
    }

    private TokenRequest tokenRequest(OIDCProviderMetadata metadata, String code, Secrets secrets) {
        AuthorizationCodeGrant grant =
                new AuthorizationCodeGrant(new AuthorizationCode(code), settings.callback(), secrets.verifier());
        String secret = settings.client().secret();
        URI address = metadata.getTokenEndpointURI();
        if (secret == null) {
            return new TokenRequest.Builder(address, client, grant).build();
        }
        List<ClientAuthenticationMethod> methods = metadata.getTokenEndpointAuthMethods();
        boolean basic = methods == null || methods.contains(ClientAuthenticationMethod.CLIENT_SECRET_BASIC);
        return new TokenRequest.Builder(
                        address,
                        basic
                                ? new ClientSecretBasic(client, new Secret(secret))
                                : new ClientSecretPost(client, new Secret(secret)),
                        grant)
                .build();
    }

    /** Asked when it is first needed, so that a provider that is down keeps no server from starting. */
    private ProviderConfiguration known() throws OidcSignInException {
        ProviderConfiguration before = known;
        if (before != null) {
            return before;
        }
        try {
            Issuer issuer = new Issuer(settings.issuer());
            OIDCProviderMetadata metadata = OIDCProviderMetadata.resolve(issuer, PATIENCE_MILLIS, PATIENCE_MILLIS);
            JWKSource<SecurityContext> keys = JWKSourceBuilder.create(
                            metadata.getJWKSetURI().toURL(),
                            new DefaultResourceRetriever(PATIENCE_MILLIS, PATIENCE_MILLIS, LARGEST_KEYS_BYTES))
                    .build();
            IDTokenValidator validator =
                    new IDTokenValidator(issuer, client, new JWSVerificationKeySelector<>(SIGNATURES, keys), null);
            ProviderConfiguration now = new ProviderConfiguration(metadata, validator);
            known = now;
            return now;
        } catch (GeneralException | IOException e) {
            throw new OidcSignInException("the provider " + settings.issuer() + " does not say how to use it", e);
        }
    }
}
