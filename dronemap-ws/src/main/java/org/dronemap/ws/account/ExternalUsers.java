package org.dronemap.ws.account;

import java.util.Optional;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.AccountState;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.User;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.reading.SecretGenerator;
import org.jspecify.annotations.Nullable;

/**
 * Finds or creates, in the first organisation, the accounts of people whom an OpenID Connect provider vouches for. Any
 * thread.
 */
public final class ExternalUsers {
    private static final int LONGEST_OWN = 23;
    private static final int MARK = 16;
    /** In no name that anybody can choose, so that nobody takes such an account beforehand. */
    private static final String BETWEEN = "~";

    private final AccessStore store;
    private final AccountChanges accounts;
    private final PasswordHashing passwords;
    private final SecretGenerator secrets;

    /**
     * Identity asserted by an external authority; authority and subject together never change, the rest may.
     *
     * @param name what people may read, if it says one
     * @param role null: roles are given here
     */
    public record Identity(
            String authority,
            String subject,
            @Nullable String name,
            @Nullable Role role) {}

    public ExternalUsers(
            AccessStore store, AccountChanges accounts, PasswordHashing passwords, SecretGenerator secrets) {
        this.store = store;
        this.accounts = accounts;
        this.passwords = passwords;
        this.secrets = secrets;
    }

    /** The user with the role that the authority gives now; a new one, in that state, when there was none. */
    public User admit(Identity identity, AccountState whenNew) {
        String mark = BETWEEN
                + SecretGenerator.hash(identity.authority() + "\n" + identity.subject())
                        .substring(0, MARK);
        User user = find(mark).orElseGet(() -> add(identity, mark, whenNew));
        Role role = identity.role();
        if (role == null || role == user.role()) {
            return user;
        }
        User changed = user.withRole(role);
        store.updateUser(changed);
        accounts.notifyListeners(user.name());
        return changed;
    }

    private Optional<User> find(String mark) {
        return store.users().stream().filter(user -> user.name().endsWith(mark)).findFirst();
    }

    private synchronized User add(Identity identity, String mark, AccountState state) {
        Optional<User> meanwhile = find(mark);
        if (meanwhile.isPresent()) {
            return meanwhile.get();
        }
        String asked = identity.name() == null ? "" : identity.name().replaceAll("[^\\p{L}\\p{N}._@-]", "");
        String own = asked.isEmpty() ? "user" : asked.substring(0, Math.min(LONGEST_OWN, asked.length()));
        Role role = identity.role() == null ? Role.VIEWER : identity.role();
        // Of a password that nobody knows.
        User user = new User(own + mark, role, state, passwords.hash(secrets.token()), false);
        if (!store.addUser(user)) {
            throw Rejection.of(
                    AccessProblem.NAME_TAKEN,
                    "The name " + user.name() + " is taken; ask an administrator.",
                    ProblemParameter.NAME.is(user.name()));
        }
        return user;
    }
}
