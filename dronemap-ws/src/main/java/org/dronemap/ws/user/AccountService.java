package org.dronemap.ws.user;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Size;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.KeyScope;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.User;
import org.dronemap.ws.account.AccountChanges;
import org.dronemap.ws.account.InitialPassword;
import org.dronemap.ws.account.PasswordHashing;
import org.dronemap.ws.account.PasswordRule;
import org.dronemap.ws.account.PasswordVerification;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ValueProblem;
import org.jspecify.annotations.Nullable;

/** Lets users change their own password and sign out of their sessions. Any thread. */
final class AccountService {
    private final AccessStore store;
    private final AccountChanges accounts;
    private final PasswordHashing passwords;
    private final PasswordVerification ownPassword;
    private final InitialPassword firstPassword;

    /** A change of one's own password. */
    @Schema(name = "PasswordRequest")
    record PasswordRequest(
            @Nullable String current,

            @Size(min = PasswordRule.SHORTEST, max = PasswordRule.LONGEST) @Nullable
            String next) {}

    AccountService(
            AccessStore store,
            AccountChanges accounts,
            PasswordHashing passwords,
            PasswordVerification ownPassword,
            InitialPassword firstPassword) {
        this.store = store;
        this.accounts = accounts;
        this.passwords = passwords;
        this.ownPassword = ownPassword;
        this.firstPassword = firstPassword;
    }

    /** Ends every session of the user but the one kept. {@code address}: where it is asked for. */
    void changePassword(Principal principal, String keepTokenHash, PasswordRequest request, String address) {
        User user = store.user(principal.name())
                .orElseThrow(() -> Rejection.of(
                        AccessProblem.NO_OWN_ACCOUNT, "Only a user who signed in by password has one to change."));
        if (isLimited(principal, user)) {
            throw Rejection.of(
                    AccessProblem.KEY_LIMITED, "A limited access key changes no password; sign in to do this.");
        }
        String current = request.current();
        if (current == null) {
            throw InvalidInput.missing("current", "your present password");
        }
        String next = PasswordRule.acceptable("next", request.next());
        if (!ownPassword.isOf(user, current, address)) {
            throw new InvalidInput(
                    ValueProblem.PRESENT_PASSWORD_WRONG,
                    "current",
                    "your present password",
                    "The present password is not right.");
        }
        if (next.equals(current)) {
            throw new InvalidInput(
                    ValueProblem.PASSWORD_UNCHANGED,
                    "next",
                    "another password",
                    "The new password must be another one than the present.");
        }
        String hash = passwords.hash(next);
        accounts.changeOwn(user.name(), before -> before.withPassword(hash, false), keepTokenHash);
        firstPassword.changed(user.name());
    }

    /** One session of the user has just ended: its open streams are told, and closed. */
    void signedOut(Principal principal) {
        accounts.notifyListeners(principal.name());
    }

    /** Ends every session of the user, this one, too, with their open streams; access keys stay. */
    void signOutEverywhere(Principal principal) {
        if (store.user(principal.name())
                .filter(user -> !isLimited(principal, user))
                .isEmpty()) {
            throw Rejection.of(AccessProblem.KEY_LIMITED, "A limited access key ends no sessions; sign in to do this.");
        }
        store.deleteOtherSignIns(principal.name(), "");
        accounts.notifyListeners(principal.name());
    }

    /** By a key that reaches less far than its owner does. */
    private static boolean isLimited(Principal principal, User user) {
        return !principal.scope().equals(KeyScope.ALL) || principal.role() != user.role();
    }
}
