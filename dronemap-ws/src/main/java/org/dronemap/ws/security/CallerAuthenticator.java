package org.dronemap.ws.security;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.Comparator;
import java.util.Optional;
import org.dronemap.core.access.AccessKey;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.EffectivePermissions;
import org.dronemap.core.access.GrantRegistry;
import org.dronemap.core.access.KeyRights;
import org.dronemap.core.access.KeyScope;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.SignIn;
import org.dronemap.core.access.User;
import org.dronemap.core.audit.AuditedCall;
import org.dronemap.core.organisation.Organisation;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.account.InitialPassword;
import org.dronemap.ws.account.PasswordHashing;
import org.dronemap.ws.account.PasswordVerification;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.SecretGenerator;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/**
 * Authenticates callers of all faces by session, access key or name and password, and opens and ends sessions. Any
 * thread.
 */
public final class CallerAuthenticator implements PasswordVerification {
    /** How long a browser stays signed in. */
    public static final Duration SESSION_LENGTH = Duration.ofHours(12);

    private static final String WRONG = "The name or the password is not right.";
    private static final String PASSWORD_SEEN =
            "Somebody else has seen your password; take one of your own first, then everything works.";
    private static final String WRONG_KEY =
            "The access key is not valid; it may have been removed, renewed or expired.";

    private final AccessStore store;
    private final PasswordHashing passwords;
    private final SecretGenerator secrets;
    private final Clock clock;
    private final GrantRegistry grants;
    private final SignInThrottle throttle;
    private final InitialPassword firstPassword;
    private final AccessKeyUsageRecorder keyUses;
    private final String localKeyHash;
    private final String nobodysHash;

    /** A name and a password as a client writes them. */
    @Schema(name = "Credentials")
    public record Credentials(
            @Nullable String name, @Nullable String password) {}

    /** Signed-in user of a session; {@code organisation}: its name, null for the default one. */
    @Schema(name = "SessionView")
    public record SessionView(
            String name,
            @EnumValues(Role.class) String role,
            boolean mustChangePassword,
            @Nullable String organisation) {}

    /** A new session with the token that goes into the cookie. */
    public record NewSession(String token, SessionView view) {}

    /** Means of verifying credentials: the hashes, and the key of the machine's owner; and the registry of grants. */
    public record Verifiers(
            PasswordHashing passwords, SecretGenerator secrets, String localKey, GrantRegistry grants) {}

    public CallerAuthenticator(AccessStore store, Verifiers means, InitialPassword firstPassword, Clock clock) {
        this.store = store;
        this.passwords = means.passwords();
        this.secrets = means.secrets();
        this.localKeyHash = SecretGenerator.hash(means.localKey());
        this.firstPassword = firstPassword;
        this.clock = clock;
        this.grants = means.grants();
        this.throttle = new SignInThrottle(clock);
        this.keyUses = new AccessKeyUsageRecorder(store, clock);
        this.nobodysHash = passwords.hash(secrets.token());
    }

    public NewSession signIn(Credentials credentials, String address) {
        return session(check(credentials, address));
    }

    /** For whom somebody else has vouched. */
    public NewSession signInProved(User user) {
        return session(active(user));
    }

    private NewSession session(User user) {
        isKnown(new Principal(user.name(), user.role()), "page");
        String token = secrets.token();
        store.addSignIn(new SignIn(
                SecretGenerator.hash(token), user.name(), clock.instant().plus(SESSION_LENGTH)));
        return new NewSession(token, view(user));
    }

    public void signOut(AuthenticatedCaller caller) {
        String hash = caller.sessionHash();
        if (hash != null) {
            store.deleteSignIn(hash);
        }
    }

    public SessionView session(AuthenticatedCaller caller) {
        Principal principal = caller.principal();
        return store.user(principal.name())
                .filter(user -> caller.proof() != AuthenticatedCaller.Proof.KEY)
                .map(this::view)
                .orElseGet(() -> new SessionView(
                        principal.name(), WireNames.camel(principal.role()), false, nameOf(principal.organisation())));
    }

    /** Empty when there is no such session any more. */
    public Optional<AuthenticatedCaller> bySession(String token) {
        Optional<AuthenticatedCaller> caller = bySessionHash(SecretGenerator.hash(token));
        caller.ifPresent(one -> isKnown(one.principal(), "page"));
        return caller;
    }

    /** What is taken down of a call names whoever has proved to be somebody, and nobody else. */
    private static void isKnown(Principal principal, @Nullable String face) {
        AuditedCall.current().ifPresent(call -> {
            call.by(principal);
            if (face != null) {
                call.face(face);
            }
        });
    }

    /** A key never does more than its owner may now. */
    public AuthenticatedCaller byKey(String key) {
        AuthenticatedCaller caller = byKeyHash(SecretGenerator.hash(key))
                .orElseThrow(() -> Rejection.of(AccessProblem.ACCESS_KEY_WRONG, WRONG_KEY));
        isKnown(caller.principal(), null);
        String id = caller.principal().key();
        if (id != null) {
            keyUses.used(id);
        }
        return caller;
    }

    /** The same caller as things are now, for what stays open; empty when the proof is good no longer. */
    public Optional<AuthenticatedCaller> still(AuthenticatedCaller caller) {
        String hash = caller.tokenHash();
        if (hash == null) {
            return store.user(caller.principal().name())
                    .filter(User::isActive)
                    .map(user -> signedIn(user, AuthenticatedCaller.Proof.PASSWORD, null, null));
        }
        return caller.proof() == AuthenticatedCaller.Proof.SESSION ? bySessionHash(hash) : byKeyHash(hash);
    }

    private Optional<AuthenticatedCaller> bySessionHash(String hash) {
        return store.signIn(hash, clock.instant())
                .flatMap(signIn -> store.user(signIn.user())
                        .filter(User::isActive)
                        .map(user -> signedIn(user, AuthenticatedCaller.Proof.SESSION, hash, signIn.expiresAt())));
    }

    private Optional<AuthenticatedCaller> byKeyHash(String hash) {
        if (hash.equals(localKeyHash)) {
            Principal owner = administrator();
            return Optional.of(new AuthenticatedCaller(owner, AuthenticatedCaller.Proof.KEY, hash, null, false));
        }
        return store.accessKey(hash)
                .filter(key -> !key.rights().isOver(clock.instant()))
                .flatMap(key -> store.user(key.owner()).filter(User::isActive).map(owner -> byKey(key, owner)));
    }

    private AuthenticatedCaller byKey(AccessKey key, User owner) {
        KeyRights rights = key.rights();
        Role role = owner.role().includes(rights.role()) ? rights.role() : owner.role();
        Principal principal = Principal.of(owner, role, rights.scope(), key.id(), reach(owner));
        return new AuthenticatedCaller(
                principal, AuthenticatedCaller.Proof.KEY, key.secretHash(), rights.expiresAt(), false);
    }

    private AuthenticatedCaller signedIn(
            User user, AuthenticatedCaller.Proof proof, @Nullable String hash, @Nullable Instant until) {
        Principal principal = Principal.of(user, user.role(), KeyScope.ALL, null, reach(user));
        return new AuthenticatedCaller(principal, proof, hash, until, user.mustChangePassword());
    }

    private EffectivePermissions reach(User user) {
        return grants.permissionsOf(user.organisation(), user.name());
    }

    /** Whoever owns the machine acts as its first administrator. */
    private Principal administrator() {
        EffectivePermissions everywhere = grants.permissionsOf(OrganisationId.HOME);
        return store.users().stream()
                .filter(user -> user.role() == Role.ADMINISTRATOR
                        && user.isActive()
                        && user.organisation().isHome())
                .min(Comparator.comparing(user -> user.name().equals(InitialAdministrator.ADMIN) ? "" : user.name()))
                .map(user -> Principal.of(user, Role.ADMINISTRATOR, KeyScope.ALL, null, everywhere))
                .orElseGet(() ->
                        new Principal(InitialAdministrator.ADMIN, Role.ADMINISTRATOR, KeyScope.ALL, null, everywhere));
    }

    public AuthenticatedCaller byPassword(String name, String password, String address) {
        User user = check(new Credentials(name, password), address);
        isKnown(new Principal(user.name(), user.role()), null);
        return signedIn(user, AuthenticatedCaller.Proof.PASSWORD, null, null);
    }

    /**
     * Refuses everything but sign-in and password change while a password is in use that others have seen, and
     * everything to those who may not even look.
     */
    public void admit(AuthenticatedCaller caller) {
        Optional<String> closed = firstPassword.closed();
        if (closed.isPresent()) {
            throw Rejection.of(AccessProblem.FIRST_PASSWORD_SEEN, closed.get());
        }
        if (caller.passwordSeen() && !firstPassword.mayStay(caller.principal().name())) {
            throw Rejection.of(AccessProblem.PASSWORD_SEEN, PASSWORD_SEEN);
        }
        RoleChecks.require(caller.principal(), Role.VIEWER);
    }

    private User check(Credentials credentials, String address) {
        String name = credentials.name();
        String password = credentials.password();
        if (name == null || name.isEmpty()) {
            throw InvalidInput.missing("name", "your user name");
        }
        if (password == null) {
            throw InvalidInput.missing("password", "your password");
        }
        Optional<User> user = store.user(name);
        // A name that is none may be a password in the wrong field.
        user.ifPresent(known -> AuditedCall.current().ifPresent(call -> call.parameters("name=" + known.name())));
        // an unknown name takes as long as a wrong password, so that names cannot be found out
        boolean right = isRight(name, password, user.map(User::passwordHash).orElse(nobodysHash), address);
        if (!right || user.isEmpty()) {
            throw Rejection.of(AccessProblem.CREDENTIALS_WRONG, WRONG);
        }
        return active(user.get());
    }

    @Override
    public boolean isOf(User user, String password, String address) {
        return isRight(user.name(), password, user.passwordHash(), address);
    }

    private boolean isRight(String name, String password, String hash, String address) {
        throttle.check(name, address);
        boolean right = passwords.matches(password, hash);
        if (right) {
            throttle.right(name, address);
        } else {
            throttle.wrong(name, address);
        }
        return right;
    }

    /** Told only to who knows the password. */
    private static User active(User user) {
        return switch (user.state()) {
            case ACTIVE -> user;
            case WAITING ->
                throw Rejection.of(
                        AccessProblem.ACCOUNT_WAITS,
                        "Your account waits until an administrator lets you in; try again later.");
            case DISABLED ->
                throw Rejection.of(
                        AccessProblem.ACCOUNT_DISABLED, "Your account has been disabled; ask an administrator.");
        };
    }

    private SessionView view(User user) {
        return new SessionView(
                user.name(), WireNames.camel(user.role()), user.mustChangePassword(), nameOf(user.organisation()));
    }

    private @Nullable String nameOf(OrganisationId id) {
        return id.isHome()
                ? null
                : grants.directory().organisations().stream()
                        .filter(organisation -> organisation.id().equals(id))
                        .map(Organisation::name)
                        .findFirst()
                        .orElse(id.value());
    }
}
