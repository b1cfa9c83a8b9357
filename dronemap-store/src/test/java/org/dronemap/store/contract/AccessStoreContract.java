package org.dronemap.store.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Instant;
import java.util.List;
import java.util.Set;
import org.dronemap.core.access.AccessKey;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.AccountState;
import org.dronemap.core.access.Invitation;
import org.dronemap.core.access.KeyRights;
import org.dronemap.core.access.KeyScope;
import org.dronemap.core.access.Permission;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.SignIn;
import org.dronemap.core.access.User;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.core.zone.AltitudeBand;
import org.dronemap.core.zone.FlightBounds;
import org.dronemap.store.StoreException;
import org.dronemap.store.UserSessionLimit;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What every {@link AccessStore} keeps to. */
public abstract class AccessStoreContract {
    private static final Instant NOW = Instant.parse("2026-03-04T05:06:07.5Z");
    private static final User ALICE = new User("alice", Role.ADMINISTRATOR, AccountState.ACTIVE, "salt$hash", true);
    private static final User BOB = new User("bob", Role.VIEWER, AccountState.ACTIVE, "salt$other", false);

    private AccessStore store;

    /** An empty store. */
    protected abstract AccessStore emptyStore();

    @BeforeEach
    void open() {
        store = emptyStore();
    }

    /** As they were given; their ids are the store's. */
    private List<User> users() {
        return store.users().stream()
                .map(user -> new User(
                        user.name(),
                        user.role(),
                        user.state(),
                        user.passwordHash(),
                        user.mustChangePassword(),
                        user.organisation()))
                .toList();
    }

    @Test
    void givesAnIdThatNobodyHadBeforeAlsoForTheSameName() {
        store.addUser(ALICE);
        String first = store.user("alice").orElseThrow().account();
        store.updateUser(store.user("alice").orElseThrow().withRole(Role.VIEWER));
        assertThat(store.user("alice").orElseThrow().account()).isEqualTo(first);
        store.deleteUser("alice");
        store.addUser(BOB);
        store.addUser(ALICE);
        assertThat(store.user("alice").orElseThrow().account())
                .isNotEqualTo(first)
                .isNotEqualTo(store.user("bob").orElseThrow().account())
                .startsWith("#");
    }

    @Test
    void givesBackUsersByName() {
        assertThat(store.users()).isEmpty();
        assertThat(store.addUser(BOB)).isTrue();
        assertThat(store.addUser(ALICE)).isTrue();
        assertThat(users()).containsExactly(ALICE, BOB);
        assertThat(users()).contains(ALICE);
        assertThat(store.user("carol")).isEmpty();
    }

    @Test
    void refusesANameThatIsTaken() {
        store.addUser(ALICE);
        assertThat(store.addUser(new User("alice", Role.VIEWER, AccountState.ACTIVE, "x", false)))
                .isFalse();
        assertThat(users()).contains(ALICE);
    }

    @Test
    void updatesAUserAndRefusesOneThatIsNotThere() {
        store.addUser(ALICE);
        User changed = new User("alice", Role.SUPERVISOR, AccountState.DISABLED, "new$hash", false);
        store.updateUser(changed);
        assertThat(users()).containsExactly(changed);
        assertThatThrownBy(() -> store.updateUser(BOB))
                .isInstanceOf(StoreException.class)
                .hasMessageContaining("bob");
    }

    @Test
    void removesAUserWithSessionsAndKeys() {
        store.addUser(ALICE);
        store.addUser(BOB);
        store.addSignIn(new SignIn("token", "alice", NOW.plusSeconds(60)));
        store.addAccessKey(key("k1", "alice", "secret"));
        store.addAccessKey(key("k2", "bob", "other"));
        assertThat(store.deleteUser("alice")).isTrue();
        assertThat(store.deleteUser("alice")).isFalse();
        assertThat(users()).containsExactly(BOB);
        assertThat(store.signIn("token", NOW)).isEmpty();
        assertThat(store.accessKey("secret")).isEmpty();
        assertThat(store.accessKeys("bob")).containsExactly(key("k2", "bob", "other"));
    }

    @Test
    void knowsASessionUntilItEnds() {
        store.addUser(ALICE);
        SignIn signIn = new SignIn("token", "alice", NOW.plusSeconds(60));
        store.addSignIn(signIn);
        assertThat(store.signIn("token", NOW)).contains(signIn);
        assertThat(store.signIn("token", NOW.plusSeconds(60))).isEmpty();
        assertThat(store.signIn("nonsense", NOW)).isEmpty();
    }

    @Test
    void endsOneSessionOrAllTheOthers() {
        store.addUser(ALICE);
        store.addUser(BOB);
        for (String token : new String[] {"one", "two", "three"}) {
            store.addSignIn(new SignIn(token, "alice", NOW.plusSeconds(60)));
        }
        store.addSignIn(new SignIn("of-bob", "bob", NOW.plusSeconds(60)));
        store.deleteSignIn("one");
        assertThat(store.signIn("one", NOW)).isEmpty();
        store.deleteOtherSignIns("alice", "three");
        assertThat(store.signIn("two", NOW)).isEmpty();
        assertThat(store.signIn("three", NOW)).isPresent();
        assertThat(store.signIn("of-bob", NOW)).isPresent();
    }

    @Test
    void keepsABoundedNumberOfSessionsPerUser() {
        store.addUser(ALICE);
        for (int i = 0; i <= UserSessionLimit.PER_USER; i++) {
            store.addSignIn(new SignIn("token-" + i, "alice", NOW.plusSeconds(60 + i)));
        }
        assertThat(store.signIn("token-0", NOW)).isEmpty();
        assertThat(store.signIn("token-1", NOW)).isPresent();
        assertThat(store.signIn("token-" + UserSessionLimit.PER_USER, NOW)).isPresent();
    }

    @Test
    void refusesASessionOrKeyOfNobody() {
        assertThatThrownBy(() -> store.addSignIn(new SignIn("token", "nobody", NOW)))
                .isInstanceOf(StoreException.class);
        assertThatThrownBy(() -> store.addAccessKey(key("k1", "nobody", "secret")))
                .isInstanceOf(StoreException.class);
    }

    @Test
    void findsKeysBySecretAndByOwner() {
        store.addUser(ALICE);
        store.addUser(BOB);
        AccessKey key = key("k1", "alice", "secret");
        store.addAccessKey(key);
        assertThat(store.accessKey("secret")).contains(key);
        assertThat(store.accessKey("guess")).isEmpty();
        assertThat(store.accessKeys("alice")).containsExactly(key);
        assertThat(store.accessKeys("bob")).isEmpty();
        assertThatThrownBy(() -> store.addAccessKey(key("k2", "bob", "secret"))).isInstanceOf(StoreException.class);
    }

    @Test
    void deletesAKeyOnlyForItsOwner() {
        store.addUser(ALICE);
        store.addUser(BOB);
        store.addAccessKey(key("k1", "alice", "secret"));
        assertThat(store.deleteAccessKey("bob", "k1")).isFalse();
        assertThat(store.accessKey("secret")).isPresent();
        assertThat(store.deleteAccessKey("alice", "k1")).isTrue();
        assertThat(store.deleteAccessKey("alice", "k1")).isFalse();
        assertThat(store.accessKey("secret")).isEmpty();
    }

    @Test
    void keepsHowFarAKeyReachesAndUntilWhen() {
        store.addUser(ALICE);
        KeyScope one = new KeyScope(Set.of(new DroneId("d1"), new DroneId("d2")), Set.of(Permission.PLAN));
        KeyScope none = new KeyScope(Set.of(), Set.of(Permission.values()));
        FenceArea circle = new FenceArea.Circle(true, new Geodetic(47.397712345678, 8.5456), 500);
        FenceArea triangle = new FenceArea.Polygon(
                true, List.of(new Geodetic(47.397, 8.545), new Geodetic(47.398, 8.545), new Geodetic(47.398, 8.546)));
        KeyScope bounded = one.boundedBy(new FlightBounds(circle, AltitudeBand.ALL))
                .boundedBy(new FlightBounds(triangle, new AltitudeBand(null, 60.5, Altitude.Reference.AMSL)));
        AccessKey root = key("k1", "alice", null, new KeyRights(Role.PLANNER, bounded, NOW.plusSeconds(60)), "s1");
        AccessKey child = key("k2", "alice", "k1", new KeyRights(Role.VIEWER, none, null), "s2");
        store.addAccessKey(root);
        store.addAccessKey(child);

        assertThat(store.accessKey("s1")).contains(root);
        assertThat(store.accessKey("s2")).contains(child);
        assertThatThrownBy(() -> store.addAccessKey(key("k3", "alice", "gone", child.rights(), "s3")))
                .isInstanceOf(StoreException.class);
    }

    @Test
    void givesAKeyAnotherSecret() {
        store.addUser(ALICE);
        store.addUser(BOB);
        store.addAccessKey(key("k1", "alice", "old"));

        assertThat(store.replaceSecret("bob", "k1", "stolen")).isFalse();
        assertThat(store.replaceSecret("alice", "k1", "new")).isTrue();

        assertThat(store.accessKey("old")).isEmpty();
        assertThat(store.accessKey("stolen")).isEmpty();
        assertThat(store.accessKey("new")).contains(key("k1", "alice", "new"));
    }

    @Test
    void remembersTheLastUseOfAKey() {
        store.addUser(ALICE);
        store.addAccessKey(key("k1", "alice", "secret"));

        store.accessKeyUsed("k1", NOW.plusSeconds(60));
        store.accessKeyUsed("k1", NOW);
        store.accessKeyUsed("gone", NOW);

        assertThat(store.accessKey("secret").orElseThrow().lastUsedAt()).isEqualTo(NOW.plusSeconds(60));
    }

    @Test
    void removesAKeyWithAllThatWereMadeFromIt() {
        store.addUser(ALICE);
        KeyRights rights = new KeyRights(Role.VIEWER, KeyScope.ALL, null);
        store.addAccessKey(key("k1", "alice", "one"));
        store.addAccessKey(key("k2", "alice", "k1", rights, "two"));
        store.addAccessKey(key("k3", "alice", "k2", rights, "three"));
        store.addAccessKey(key("k4", "alice", "four"));

        assertThat(store.deleteAccessKey("alice", "k1")).isTrue();

        assertThat(store.accessKeys("alice")).extracting(AccessKey::id).containsExactly("k4");
    }

    @Test
    void takesEveryRoleAndState() {
        for (Role role : Role.values()) {
            User user = new User("u-" + role, role, AccountState.WAITING, "h", false);
            assertThat(store.addUser(user)).isTrue();
            assertThat(users()).contains(user);
        }
    }

    @Test
    void keepsInvitationsUntilTheyExpire() {
        Invitation soon = invitation("i1", "code", NOW.plusSeconds(60));
        Invitation later = invitation("i2", "other", NOW.plusSeconds(120));
        store.addInvitation(later, NOW);
        store.addInvitation(soon, NOW);
        assertThat(store.invitations(NOW)).containsExactly(soon, later);
        assertThat(store.invitation("code", NOW)).contains(soon);
        assertThat(store.invitation("guess", NOW)).isEmpty();
        assertThat(store.invitation("code", NOW.plusSeconds(60))).isEmpty();
        assertThat(store.invitations(NOW.plusSeconds(60))).containsExactly(later);
        store.addInvitation(invitation("i3", "third", NOW.plusSeconds(300)), NOW.plusSeconds(120));
        assertThat(store.invitations(NOW)).extracting(Invitation::id).containsExactly("i3");
        assertThat(store.deleteInvitation("i3")).isTrue();
        assertThat(store.deleteInvitation("i3")).isFalse();
    }

    @Test
    void usesAnInvitationOnce() {
        store.addUser(ALICE);
        store.addInvitation(invitation("i1", "code", NOW.plusSeconds(60)), NOW);
        assertThat(store.acceptInvitation("i1", ALICE))
                .as("a name that is taken")
                .isFalse();
        assertThat(store.invitation("code", NOW))
                .as("the invitation after that")
                .isPresent();
        assertThat(store.acceptInvitation("i1", BOB)).isTrue();
        assertThat(users()).containsExactly(ALICE, BOB);
        assertThat(store.invitation("code", NOW)).isEmpty();
        assertThat(store.acceptInvitation("i1", new User("eve", Role.VIEWER, AccountState.ACTIVE, "x", false)))
                .isFalse();
        assertThat(store.user("eve")).isEmpty();
    }

    private static Invitation invitation(String id, String codeHash, Instant until) {
        return new Invitation(id, "for bob", Role.PLANNER, codeHash, "alice", "#a1", until, OrganisationId.HOME);
    }

    private static AccessKey key(String id, String owner, String secretHash) {
        return key(id, owner, null, new KeyRights(Role.OPERATOR, KeyScope.ALL, null), secretHash);
    }

    private static AccessKey key(
            String id, String owner, @Nullable String parent, KeyRights rights, String secretHash) {
        return new AccessKey(id, "script of " + owner, owner, parent, rights, secretHash, NOW, null);
    }
}
