package org.dronemap.ws.user;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Size;
import java.util.List;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.AccountState;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.User;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.account.AccountChanges;
import org.dronemap.ws.account.PasswordHashing;
import org.dronemap.ws.account.PasswordRule;
import org.dronemap.ws.account.UserNameRules;
import org.dronemap.ws.organisation.GrantChanges;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.SecretGenerator;
import org.jspecify.annotations.Nullable;

/** Lets administrators create, change, sign out and delete users. Any thread. */
public final class UserService {
    private static final String STATES = "active or disabled";

    private final AccessStore store;
    private final AccountChanges accounts;
    private final PasswordHashing passwords;
    private final SecretGenerator secrets;
    private final GrantChanges grants;

    /** A new user as an administrator writes it. */
    @Schema(name = "NewUser")
    public record NewUser(
            @Nullable String name,
            @EnumValues(Role.class) @Nullable String role,

            @Size(min = PasswordRule.SHORTEST, max = PasswordRule.LONGEST) @Nullable
            String password) {}

    /**
     * Request to change a user's role or state; null leaves it as it is. A user who waits is let in by {@code "state":
     * "active"}.
     */
    @Schema(name = "UserChange")
    public record Change(
            @EnumValues(Role.class) @Nullable String role,

            @Schema(allowableValues = {"active", "disabled"}) @Nullable
            String state) {}

    /** A password that works until the user has taken one of their own; there once, in the answer that made it. */
    @Schema(name = "OneTimePassword")
    public record OneTimePassword(String name, String password) {}

    public UserService(
            AccessStore store,
            AccountChanges accounts,
            PasswordHashing passwords,
            SecretGenerator secrets,
            GrantChanges grants) {
        this.grants = grants;
        this.store = store;
        this.accounts = accounts;
        this.passwords = passwords;
        this.secrets = secrets;
    }

    public List<UserView> users(Principal principal) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        return store.users().stream()
                .filter(user -> user.organisation().equals(principal.organisation()))
                .map(user -> UserView.of(user, grants.isOnlyGranted(user.name())))
                .toList();
    }

    public UserView add(Principal principal, NewUser request) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        String name = UserNameRules.checked(request.name());
        Role role = RoleChecks.named(request.role());
        String password = PasswordRule.acceptable("password", request.password());
        User user = new User(name, role, AccountState.ACTIVE, passwords.hash(password), true, principal.organisation());
        if (!accounts.add(user, store::addUser)) {
            throw Rejection.of(
                    AccessProblem.NAME_TAKEN,
                    "There is a user " + name + " already, or one whose name looks like it.",
                    ProblemParameter.NAME.is(name));
        }
        return UserView.of(user, false);
    }

    public UserView change(Principal principal, String name, Change change) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        String roleName = change.role();
        String stateName = change.state();
        if (roleName == null && stateName == null) {
            throw InvalidInput.missing("role", "a role, or \"state\": " + STATES);
        }
        Role role = roleName == null ? null : RoleChecks.named(roleName);
        AccountState state = stateName == null ? null : state(stateName);
        if (state == AccountState.DISABLED) {
            accounts.changeOtherAndSignOut(principal, name, user -> changed(user, role, state));
        } else {
            accounts.changeOther(principal, name, user -> changed(user, role, state));
        }
        return UserView.of(accounts.find(principal, name), grants.isOnlyGranted(name));
    }

    /** Also ends the user's sessions; access keys stay, and can be removed one by one. */
    public OneTimePassword resetPassword(Principal principal, String name) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        String password = secrets.password();
        String hash = passwords.hash(password);
        accounts.changeOtherAndSignOut(principal, name, user -> user.withPassword(hash, true));
        return new OneTimePassword(name, password);
    }

    public void signOut(Principal principal, String name) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        accounts.find(principal, name);
        store.deleteOtherSignIns(name, "");
        accounts.notifyListeners(name);
    }

    public void delete(Principal principal, String name) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        accounts.delete(principal, name);
        grants.forgetUser(name);
    }

    private static User changed(User user, @Nullable Role role, @Nullable AccountState state) {
        User withRole = role == null ? user : user.withRole(role);
        return state == null ? withRole : withRole.withState(state);
    }

    private static AccountState state(String text) {
        return switch (text) {
            case "active" -> AccountState.ACTIVE;
            case "disabled" -> AccountState.DISABLED;
            default -> throw InvalidInput.outside(ValueProblem.VALUE_NOT_ALLOWED, "state", STATES, "\"" + text + "\"");
        };
    }
}
