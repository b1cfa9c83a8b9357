package org.dronemap.ws.user;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.tags.Tag;
import jakarta.servlet.http.Cookie;
import jakarta.servlet.http.HttpServletRequest;
import java.net.URI;
import java.time.Duration;
import java.util.Optional;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.AuditNotes;
import org.dronemap.ws.access.AuditPolicy;
import org.dronemap.ws.access.RequestCost;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.access.WithoutSoap;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.ProblemView;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RejectionKind;
import org.dronemap.ws.security.CallerAuthenticator;
import org.dronemap.ws.security.SessionCookie;
import org.dronemap.ws.security.oidc.OidcSignIn;
import org.jspecify.annotations.Nullable;
import org.springframework.http.HttpHeaders;
import org.springframework.http.HttpStatus;
import org.springframework.http.ResponseCookie;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.RestController;
import org.springframework.web.util.WebUtils;

/** Redirects browsers to the OpenID Connect provider for sign-in, and takes them back. */
@RestController
@RequestMapping("/api/v1/session/oidc")
@Tag(name = "Session")
class OidcController {
    private static final String COOKIE = "dronemap-oidc";
    private static final String PATH = "/api/v1/session/oidc";
    private static final Duration LONGEST = Duration.ofMinutes(10);

    private final Optional<OidcSignIn> signIn;

    OidcController(Optional<OidcSignIn> signIn) {
        this.signIn = signIn;
    }

    @GetMapping
    @Access(from = AccessLevel.ANYBODY, about = ResourceScope.OWN, costs = RequestCost.SIGN_IN)
    @ResponseStatuses(value = 302, refuses = 404)
    @WithoutSoap("Sends a browser to another address.")
    @Operation(
            operationId = "startSignInElsewhere",
            summary = "Go to the provider to sign in",
            description = "For browsers; 404 when there is none.")
    public ResponseEntity<Void> start(HttpServletRequest request) {
        OidcSignIn.SignInRedirect start = oidc().start();
        return ResponseEntity.status(HttpStatus.FOUND)
                .location(start.address())
                .header(HttpHeaders.SET_COOKIE, cookie(start.browser(), request.isSecure(), LONGEST))
                .build();
    }

    @GetMapping("/callback")
    @Access(
            from = AccessLevel.ANYBODY,
            about = ResourceScope.OWN,
            costs = RequestCost.SIGN_IN,
            audit = AuditPolicy.RECORDED)
    @ResponseStatuses(value = 302, refuses = 404, never = 422)
    @WithoutSoap("Sends a browser to another address.")
    @Operation(
            operationId = "finishSignInElsewhere",
            summary = "Come back from the provider",
            description = "For browsers; leads to the page.")
    public ResponseEntity<Void> finish(
            @RequestParam(required = false) @Nullable String code,
            @RequestParam(required = false) @Nullable String state,
            HttpServletRequest request) {
        OidcSignIn oidc = oidc();
        // As it is: what is not of ours may be no text that can be decoded.
        String browser = Optional.ofNullable(WebUtils.getCookie(request, COOKIE))
                .map(Cookie::getValue)
                .orElse(null);
        ResponseEntity.BodyBuilder answer = ResponseEntity.status(HttpStatus.FOUND)
                .header(HttpHeaders.SET_COOKIE, cookie("", request.isSecure(), Duration.ZERO));
        try {
            CallerAuthenticator.NewSession session = oidc.finish(new OidcSignIn.SignInCallback(code, state, browser));
            return answer.header(HttpHeaders.SET_COOKIE, SessionCookie.issue(session.token(), request.isSecure()))
                    .location(URI.create("/"))
                    .build();
        } catch (Rejection refused) {
            AuditNotes.turnedAway(ProblemView.of(refused));
            // An account that waits or is disabled is told so; of all else a person learns only that it failed.
            boolean closed = refused.kind() == RejectionKind.FORBIDDEN;
            return answer.location(URI.create(closed ? "/?signIn=closed" : "/?signIn=failed"))
                    .build();
        }
    }

    private OidcSignIn oidc() {
        return signIn.orElseThrow(() -> Rejection.of(
                AccessProblem.NO_OTHER_PROVIDER,
                "There is no other provider to sign in with; sign in by name and password."));
    }

    /** The way back begins at another site, which a strict cookie would not be sent from. */
    private static String cookie(String value, boolean secure, Duration length) {
        return ResponseCookie.from(COOKIE, value)
                .httpOnly(true)
                .secure(secure)
                .sameSite("Lax")
                .path(PATH)
                .maxAge(length)
                .build()
                .toString();
    }
}
