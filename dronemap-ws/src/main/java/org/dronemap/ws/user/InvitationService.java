package org.dronemap.ws.user;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
import jakarta.validation.constraints.Size;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.UUID;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.Invitation;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.organisation.OrganisationService;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ServerProblem;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.NameRules;
import org.dronemap.ws.reading.SecretGenerator;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/** Creates, lists and withdraws invitations to make an account, for administrators. Any thread. */
final class InvitationService {
    private static final int DEFAULT_DAYS = 7;
    static final int MOST_DAYS = 30;
    private static final int MOST_OPEN = 500;
    static final int LONGEST_LABEL = 60;

    private final AccessStore store;
    private final OrganisationService organisations;
    private final SecretGenerator secrets;
    private final Clock clock;

    /**
     * Request for an invitation: label, role, days and organisation; by default seven days, and the asker's
     * organisation.
     */
    @Schema(name = "NewInvitation")
    record NewInvitation(
            @Size(min = 1, max = InvitationService.LONGEST_LABEL) @Nullable
            String label,

            @EnumValues(Role.class) @Nullable String role,

            @Min(1) @Max(InvitationService.MOST_DAYS) @Nullable
            Integer days,

            @Nullable String organisation) {}

    /**
     * An invitation as administrators see it.
     *
     * @param code there once, in the answer that made it
     */
    @Schema(name = "InvitationView")
    record InvitationView(
            String id,
            String label,
            @EnumValues(Role.class) String role,
            String invitedBy,
            Instant expiresAt,
            @Nullable String code) {}

    InvitationService(AccessStore store, OrganisationService organisations, SecretGenerator secrets, Clock clock) {
        this.organisations = organisations;
        this.store = store;
        this.secrets = secrets;
        this.clock = clock;
    }

    List<InvitationView> invitations(Principal principal) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        return store.invitations(clock.instant()).stream()
                .filter(invitation -> isShownTo(principal, invitation))
                .map(invitation -> view(invitation, null))
                .toList();
    }

    InvitationView invite(Principal principal, NewInvitation request) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        String label = NameRules.checked("label", request.label(), LONGEST_LABEL);
        Role role = RoleChecks.named(request.role());
        Integer asked = request.days();
        int days = asked == null ? DEFAULT_DAYS : asked;
        if (days < 1 || days > MOST_DAYS) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_OUT_OF_RANGE,
                    "days",
                    "1 to " + MOST_DAYS,
                    days,
                    ProblemParameter.LEAST.is(1),
                    ProblemParameter.MOST.is(MOST_DAYS),
                    ProblemParameter.UNIT.is("days"));
        }
        Instant now = clock.instant();
        OrganisationId organisation = organisations.invitedInto(principal, request.organisation());
        if (store.invitations(now).size() >= MOST_OPEN) {
            throw Rejection.of(
                    ServerProblem.LIMIT_REACHED,
                    MOST_OPEN + " invitations are open already; withdraw some first.",
                    ProblemParameter.WHAT.is("invitations"),
                    ProblemParameter.MOST.is(MOST_OPEN));
        }
        String code = secrets.token();
        Invitation invitation = new Invitation(
                UUID.randomUUID().toString(),
                label,
                role,
                SecretGenerator.hash(code),
                principal.name(),
                principal.account(),
                now.plus(Duration.ofDays(days)),
                organisation);
        store.addInvitation(invitation, now);
        return view(invitation, code);
    }

    void withdraw(Principal principal, String id) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        boolean shown = store.invitations(clock.instant()).stream()
                .anyMatch(invitation -> invitation.id().equals(id) && isShownTo(principal, invitation));
        if (!shown || !store.deleteInvitation(id)) {
            throw Rejection.unknown(NotFoundProblem.INVITATION, id);
        }
    }

    /** Those into one's own organisation, and those that one gave oneself. */
    private static boolean isShownTo(Principal principal, Invitation invitation) {
        return invitation.organisation().equals(principal.organisation())
                || invitation.account().equals(principal.account());
    }

    private static InvitationView view(Invitation invitation, @Nullable String code) {
        return new InvitationView(
                invitation.id(),
                invitation.label(),
                WireNames.camel(invitation.role()),
                invitation.invitedBy(),
                invitation.expiresAt().truncatedTo(ChronoUnit.MILLIS),
                code);
    }
}
