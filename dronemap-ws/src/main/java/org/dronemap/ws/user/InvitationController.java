package org.dronemap.ws.user;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.util.List;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.security.CurrentPrincipal;
import org.springframework.http.HttpStatus;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.DeleteMapping;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;

/** REST handlers by which administrators invite people to make an account, and withdraw invitations. */
@RestController
@RequestMapping("/api/v1/invitations")
@Tag(name = "Invitations", description = "Let one person make an account without waiting; for administrators.")
class InvitationController {
    private final InvitationService invitations;
    private final CurrentPrincipal current;

    /** All that are open. */
    @Schema(name = "Invitations")
    public record Invitations(List<InvitationService.InvitationView> invitations) {}

    InvitationController(InvitationService invitations, CurrentPrincipal current) {
        this.invitations = invitations;
        this.current = current;
    }

    @GetMapping
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @Operation(operationId = "listInvitations", summary = "List the open invitations")
    public Invitations invitations() {
        return new Invitations(invitations.invitations(current.principal()));
    }

    @PostMapping
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @ResponseStatuses(201)
    @Operation(
            operationId = "addInvitation",
            summary = "Invite somebody",
            description = "The code is in this answer and never shown again; it serves once. The page takes it as"
                    + " /#invitation=CODE.")
    public ResponseEntity<InvitationService.InvitationView> invite(
            @RequestBody InvitationService.NewInvitation request) {
        return ResponseEntity.status(HttpStatus.CREATED).body(invitations.invite(current.principal(), request));
    }

    @DeleteMapping("/{id}")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(operationId = "withdrawInvitation", summary = "Withdraw an invitation")
    public void withdraw(@PathVariable String id) {
        invitations.withdraw(current.principal(), id);
    }
}
