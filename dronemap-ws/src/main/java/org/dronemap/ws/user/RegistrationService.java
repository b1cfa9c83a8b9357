package org.dronemap.ws.user;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Size;
import java.time.Clock;
import java.time.Duration;
import java.util.Optional;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.AccountState;
import org.dronemap.core.access.Invitation;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.User;
import org.dronemap.core.audit.AuditedCall;
import org.dronemap.ws.account.AccountChanges;
import org.dronemap.ws.account.InitialPassword;
import org.dronemap.ws.account.PasswordHashing;
import org.dronemap.ws.account.PasswordRule;
import org.dronemap.ws.account.UserNameRules;
import org.dronemap.ws.budget.AttemptLimiter;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ServerProblem;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.SecretGenerator;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/**
 * Lets people who are not yet users make an account for themselves, as the registration policy allows. The only use
 * case for people whom nobody knows yet. Any thread.
 */
final class RegistrationService {
    private static final int MOST_WAITING = 200;
    private static final int TIMES = 10;
    private static final Duration WITHIN = Duration.ofMinutes(10);

    private final AccessStore store;
    private final AccountChanges accounts;
    private final PasswordHashing passwords;
    private final InitialPassword firstPassword;
    private final RegistrationPolicy policy;
    private final Clock clock;
    private final AttemptLimiter throttle;

    /** Request of a person to register; the invitation is the code from its link. */
    @Schema(name = "RegistrationRequest")
    record Request(
            @Nullable String name,

            @Size(min = PasswordRule.SHORTEST, max = PasswordRule.LONGEST) @Nullable
            String password,

            @Nullable String invitation) {}

    /** Result of a registration: {@code active}, or {@code waiting} for an administrator. */
    @Schema(name = "RegistrationAnswer")
    record Answer(
            String name,
            @EnumValues(Role.class) String role,
            @Schema(allowableValues = {"active", "waiting"}) String state) {}

    RegistrationService(
            AccessStore store,
            AccountChanges accounts,
            PasswordHashing passwords,
            InitialPassword firstPassword,
            RegistrationPolicy policy,
            Clock clock) {
        this.store = store;
        this.accounts = accounts;
        this.passwords = passwords;
        this.firstPassword = firstPassword;
        this.policy = policy;
        this.clock = clock;
        this.throttle = new AttemptLimiter(clock, TIMES, WITHIN);
    }

    /** Whether and how a page should offer it. */
    String policyName() {
        return WireNames.camel(policy);
    }

    Answer register(Request request, String address) {
        if (policy == RegistrationPolicy.OFF) {
            throw Rejection.of(
                    AccessProblem.REGISTRATION_CLOSED,
                    "Accounts are made by the administrators of this server; ask one.");
        }
        firstPassword.closed().ifPresent(why -> {
            throw Rejection.of(AccessProblem.FIRST_PASSWORD_SEEN, why);
        });
        String code = request.invitation();
        // Who was invited waits for nobody else who comes from the same address.
        Optional<Invitation> invitation = code == null || code.isBlank()
                ? Optional.empty()
                : store.invitation(SecretGenerator.hash(code.strip()), clock.instant());
        throttle.acquire(
                invitation.map(Invitation::id).orElse(address),
                invitation.isPresent() ? "tries with this invitation" : "registrations from this address");
        String name = UserNameRules.checked(request.name());
        String password = PasswordRule.acceptable("password", request.password());
        if (code != null && !code.isBlank()) {
            return accept(invitation.orElseThrow(RegistrationService::notValid), name, password);
        }
        if (policy == RegistrationPolicy.INVITATION) {
            throw Rejection.of(
                    AccessProblem.INVITATION_NEEDED,
                    "Only those who were invited can make an account here; open the link of your"
                            + " invitation, or ask an administrator for one.");
        }
        return wait(name, password);
    }

    private Answer accept(Invitation invitation, String name, String password) {
        User user = new User(
                name,
                invitation.role(),
                AccountState.ACTIVE,
                passwords.hash(password),
                false,
                invitation.organisation());
        noted(user, "invitation=" + invitation.id());
        if (!accounts.add(user, one -> store.acceptInvitation(invitation.id(), one))) {
            throw nameInUse(name);
        }
        return answer(user);
    }

    private Answer wait(String name, String password) {
        long waiting = store.users().stream()
                .filter(user -> user.state() == AccountState.WAITING)
                .count();
        if (waiting >= MOST_WAITING) {
            throw Rejection.of(
                    ServerProblem.SERVER_BUSY,
                    "Too many people wait to be let in at the moment; try again later, or ask for an invitation.",
                    ProblemParameter.WHAT.is("registrations"));
        }
        // The administrator who lets them in may give another role.
        User user = new User(name, Role.VIEWER, AccountState.WAITING, passwords.hash(password), false);
        noted(user, "to be let in");
        if (!accounts.add(user, store::addUser)) {
            throw nameInUse(name);
        }
        return answer(user);
    }

    private static void noted(User user, String how) {
        AuditedCall.current().ifPresent(call -> call.parameters("name=" + user.name() + ", " + how));
    }

    private static InvalidInput notValid() {
        return new InvalidInput(
                ValueProblem.INVITATION_NOT_VALID,
                "invitation",
                "the code of an invitation",
                "This invitation was used already, has expired or was withdrawn; ask for a new one.");
    }

    private static Rejection nameInUse(String name) {
        return Rejection.of(
                AccessProblem.NAME_TAKEN,
                "The name " + name + " is taken, or looks like one that is; choose another one.",
                ProblemParameter.NAME.is(name));
    }

    private static Answer answer(User user) {
        return new Answer(user.name(), WireNames.camel(user.role()), WireNames.camel(user.state()));
    }
}
