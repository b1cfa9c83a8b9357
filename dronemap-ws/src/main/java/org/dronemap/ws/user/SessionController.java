package org.dronemap.ws.user;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.tags.Tag;
import jakarta.servlet.http.HttpServletRequest;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.AuditPolicy;
import org.dronemap.ws.access.RequestCost;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.access.WithoutSoap;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.security.AuthenticatedCaller;
import org.dronemap.ws.security.CallerAuthenticator;
import org.dronemap.ws.security.CurrentPrincipal;
import org.dronemap.ws.security.SessionCookie;
import org.springframework.http.HttpHeaders;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.DeleteMapping;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RestController;

/** REST handlers by which browsers sign in and out, and users change their password. */
@RestController
@RequestMapping("/api/v1/session")
@Tag(name = "Session", description = "Sign in by name and password; the answer's cookie is the session.")
class SessionController {
    private final CallerAuthenticator authentication;
    private final AccountService account;
    private final CurrentPrincipal current;

    SessionController(CallerAuthenticator authentication, AccountService account, CurrentPrincipal current) {
        this.authentication = authentication;
        this.account = account;
        this.current = current;
    }

    @PostMapping
    @Access(
            from = AccessLevel.ANYBODY,
            about = ResourceScope.OWN,
            costs = RequestCost.SIGN_IN,
            audit = AuditPolicy.RECORDED_WITH_PLACE)
    @ResponseStatuses(
            refuses = {401, 403},
            never = 409)
    @WithoutSoap("A browser's session is a cookie; a call of SOAP says itself who calls.")
    @Operation(
            operationId = "signIn",
            summary = "Sign in",
            description = "After five wrong passwords in a row: 429 for 30 s.")
    public ResponseEntity<CallerAuthenticator.SessionView> signIn(
            @RequestBody CallerAuthenticator.Credentials credentials, HttpServletRequest request) {
        CallerAuthenticator.NewSession session = authentication.signIn(credentials, request.getRemoteAddr());
        return ResponseEntity.ok()
                .header(HttpHeaders.SET_COOKIE, SessionCookie.issue(session.token(), request.isSecure()))
                .body(session.view());
    }

    @GetMapping
    @Access(from = AccessLevel.SIGNED_IN, about = ResourceScope.OWN)
    @ResponseStatuses(never = 403)
    @Operation(operationId = "getSession", summary = "Who is signed in")
    public CallerAuthenticator.SessionView session() {
        return authentication.session(current.signedIn());
    }

    @DeleteMapping
    @Access(from = AccessLevel.SIGNED_IN, about = ResourceScope.OWN)
    @ResponseStatuses(204)
    @WithoutSoap("A browser's session is a cookie; a call of SOAP says itself who calls.")
    @Operation(
            operationId = "signOut",
            summary = "Sign out",
            description = "Ends this session, and the streams that were opened with it.")
    public ResponseEntity<Void> signOut(HttpServletRequest request) {
        AuthenticatedCaller caller = current.signedIn();
        authentication.signOut(caller);
        account.signedOut(caller.principal());
        return ResponseEntity.noContent()
                .header(HttpHeaders.SET_COOKIE, SessionCookie.clear(request.isSecure()))
                .build();
    }

    @PostMapping("/password")
    @Access(from = AccessLevel.SIGNED_IN, about = ResourceScope.OWN)
    @ResponseStatuses(value = 204, never = 409)
    @Operation(
            operationId = "changePassword",
            summary = "Change one's own password",
            description =
                    "Ends all other sessions of the user. After five wrong present passwords in a row: 429 for 30 s.")
    public ResponseEntity<Void> changePassword(
            @RequestBody AccountService.PasswordRequest request, HttpServletRequest http) {
        AuthenticatedCaller caller = current.signedIn();
        String session = caller.sessionHash();
        account.changePassword(caller.principal(), session == null ? "" : session, request, http.getRemoteAddr());
        return ResponseEntity.noContent().build();
    }

    @PostMapping("/sign-out-everywhere")
    @Access(from = AccessLevel.SIGNED_IN, about = ResourceScope.OWN)
    @ResponseStatuses(value = 204, never = 409)
    @Operation(
            operationId = "signOutEverywhere",
            summary = "Sign out everywhere",
            description = "Ends all one's own sessions, this one too, and their open streams; access keys stay.")
    public ResponseEntity<Void> signOutEverywhere(HttpServletRequest request) {
        account.signOutEverywhere(current.principal());
        return ResponseEntity.noContent()
                .header(HttpHeaders.SET_COOKIE, SessionCookie.clear(request.isSecure()))
                .build();
    }
}
