package org.dronemap.ws.service;

import java.time.Clock;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Arrays;
import java.util.List;
import java.util.UUID;
import org.dronemap.core.access.AccessKey;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.User;
import org.jspecify.annotations.Nullable;

/** Use cases around users, passwords and access keys. Any thread. */
public final class AccessService {
    private static final String ROLES = "administrator, operator or viewer";
    private static final String NAME_FORM = "1 to 40 of letters, digits, '.', '_', '-' and '@'";
    private static final int SHORTEST_PASSWORD = 10;
    private static final int LONGEST_PASSWORD = 200;

    private final AccessStore store;
    private final PasswordHashing passwords;
    private final FirstPassword firstPassword;
    private final Secrets secrets;
    private final Clock clock;

    /** A new user as an administrator writes it. */
    public record UserRequest(
            @Nullable String name,
            @Nullable String role,
            @Nullable String password) {}

    /** A user as administrators see it. */
    public record UserView(String name, String role, boolean mustChangePassword) {}

    /** A new access key as its owner asks for it; the role is the owner's own unless a lesser one is named. */
    public record AccessKeyRequest(
            @Nullable String label, @Nullable String role) {}

    /** An access key as its owner sees it; the key itself is there once, in the answer that made it. */
    public record KeyView(
            String id,
            String label,
            String role,
            Instant createdAt,
            @Nullable String key) {}

    /** A change of one's own password. */
    public record PasswordRequest(
            @Nullable String current, @Nullable String next) {}

    public AccessService(
            AccessStore store, PasswordHashing passwords, FirstPassword firstPassword, Secrets secrets, Clock clock) {
        this.store = store;
        this.passwords = passwords;
        this.firstPassword = firstPassword;
        this.secrets = secrets;
        this.clock = clock;
    }

    public List<UserView> users(Principal principal) {
        Roles.require(principal, Role.ADMINISTRATOR);
        return store.users().stream().map(AccessService::view).toList();
    }

    public UserView addUser(Principal principal, UserRequest request) {
        Roles.require(principal, Role.ADMINISTRATOR);
        String name = request.name();
        if (name == null) {
            throw InvalidInput.missing("name", NAME_FORM);
        }
        if (!name.matches("[\\p{L}\\p{N}._@-]{1,40}")) {
            throw InvalidInput.outside("name", NAME_FORM, "\"" + name + "\"");
        }
        User user =
                new User(name, role(request.role()), passwords.hash(acceptable("password", request.password())), false);
        if (!store.addUser(user)) {
            throw Rejection.conflict("There is a user " + name + " already.");
        }
        return view(user);
    }

    public void deleteUser(Principal principal, String name) {
        Roles.require(principal, Role.ADMINISTRATOR);
        if (principal.name().equals(name)) {
            throw Rejection.conflict("You cannot remove yourself; ask another administrator.");
        }
        if (!store.deleteUser(name)) {
            throw Rejection.unknown("user", name);
        }
    }

    /** Ends every session of the user but the one kept. */
    public void changePassword(Principal principal, String keepTokenHash, PasswordRequest request) {
        User user = store.user(principal.name())
                .orElseThrow(() -> Rejection.forbidden("Only a user who signed in by password has one to change."));
        String current = request.current();
        if (current == null) {
            throw InvalidInput.missing("current", "your present password");
        }
        if (!passwords.matches(current, user.passwordHash())) {
            throw new InvalidInput("current", "your present password", "The present password is not right.");
        }
        String next = acceptable("next", request.next());
        if (next.equals(current)) {
            throw new InvalidInput(
                    "next", "another password", "The new password must be another one than the present.");
        }
        store.updateUser(new User(user.name(), user.role(), passwords.hash(next), false));
        store.deleteOtherSignIns(user.name(), keepTokenHash);
        firstPassword.changed(user.name());
    }

    public List<KeyView> keys(Principal principal) {
        return store.accessKeys(principal.name()).stream()
                .map(key -> view(key, null))
                .toList();
    }

    public KeyView addKey(Principal principal, AccessKeyRequest request) {
        if (store.user(principal.name()).isEmpty()) {
            throw Rejection.forbidden("Only a user can own access keys; sign in as one.");
        }
        Role role = request.role() == null ? principal.role() : role(request.role());
        if (!principal.role().includes(role)) {
            throw Rejection.forbidden(
                    "A key cannot do more than its owner, who is " + WireNames.camel(principal.role()) + ".");
        }
        String secret = secrets.token();
        AccessKey key = new AccessKey(
                UUID.randomUUID().toString(),
                Names.checked("label", request.label(), 60),
                principal.name(),
                role,
                Secrets.hash(secret),
                clock.instant());
        store.addAccessKey(key);
        return view(key, secret);
    }

    public void deleteKey(Principal principal, String id) {
        if (!store.deleteAccessKey(principal.name(), id)) {
            throw Rejection.unknown("access key", id);
        }
    }

    private static String acceptable(String field, @Nullable String password) {
        String allowed = SHORTEST_PASSWORD + " to " + LONGEST_PASSWORD + " characters";
        if (password == null) {
            throw InvalidInput.missing(field, allowed);
        }
        if (password.length() < SHORTEST_PASSWORD || password.length() > LONGEST_PASSWORD) {
            throw new InvalidInput(
                    field, allowed, "A password must have " + allowed + "; this one has " + password.length() + ".");
        }
        return password;
    }

    private static Role role(@Nullable String text) {
        if (text == null) {
            throw InvalidInput.missing("role", ROLES);
        }
        return Arrays.stream(Role.values())
                .filter(role -> WireNames.camel(role).equals(text))
                .findFirst()
                .orElseThrow(() -> InvalidInput.outside("role", ROLES, "\"" + text + "\""));
    }

    private static UserView view(User user) {
        return new UserView(user.name(), WireNames.camel(user.role()), user.mustChangePassword());
    }

    private static KeyView view(AccessKey key, @Nullable String secret) {
        return new KeyView(
                key.id(),
                key.label(),
                WireNames.camel(key.role()),
                key.createdAt().truncatedTo(ChronoUnit.MILLIS),
                secret);
    }
}
