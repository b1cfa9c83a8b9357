package org.dronemap.ws.user;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import jakarta.servlet.http.HttpServletRequest;
import java.util.Optional;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.AuditPolicy;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.security.oidc.OidcSignIn;
import org.jspecify.annotations.Nullable;
import org.springframework.http.HttpStatus;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RestController;

/** REST handlers by which people make an account for themselves; open to everybody. */
@RestController
@RequestMapping("/api/v1/registrations")
@Tag(name = "Registration", description = "Make an account of one's own, by invitation or to wait for approval.")
class RegistrationController {
    private final RegistrationService registrations;

    private final Optional<OidcSignIn> oidc;

    /**
     * Registration policy of the server, and its sign-in provider.
     *
     * @param policy {@code approval}, {@code invitation} or {@code off}
     * @param signInWith the provider that people can sign in with; null: none
     */
    @Schema(name = "RegistrationPolicy")
    public record Policy(
            @EnumValues(RegistrationPolicy.class) String policy,
            @Nullable String signInWith) {}

    RegistrationController(RegistrationService registrations, Optional<OidcSignIn> oidc) {
        this.oidc = oidc;
        this.registrations = registrations;
    }

    @GetMapping
    @Access(from = AccessLevel.ANYBODY, about = ResourceScope.NONE)
    @ResponseStatuses(never = 503)
    @Operation(
            operationId = "getRegistrationPolicy",
            summary = "How accounts are made here",
            description = "approval, invitation or off; needs no sign-in.")
    public Policy policy() {
        return new Policy(
                registrations.policyName(), oidc.map(OidcSignIn::label).orElse(null));
    }

    @PostMapping
    @Access(from = AccessLevel.ANYBODY, about = ResourceScope.NONE, audit = AuditPolicy.RECORDED_WITH_PLACE)
    @ResponseStatuses(
            value = {201, 202},
            refuses = 403)
    @Operation(
            operationId = "register",
            summary = "Ask for an account",
            description = "Needs no sign-in. 201: with an invitation, sign in now. 202: an administrator decides."
                    + " At most ten from one address in ten minutes.")
    public ResponseEntity<RegistrationService.Answer> register(
            @RequestBody RegistrationService.Request body, HttpServletRequest request) {
        RegistrationService.Answer answer = registrations.register(body, request.getRemoteAddr());
        HttpStatus status = answer.state().equals("waiting") ? HttpStatus.ACCEPTED : HttpStatus.CREATED;
        return ResponseEntity.status(status).body(answer);
    }
}
