package org.dronemap.store.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Instant;
import org.dronemap.core.access.AccessKey;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.SignIn;
import org.dronemap.core.access.User;
import org.dronemap.store.SignInLimit;
import org.dronemap.store.StoreException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What every {@link AccessStore} keeps to. */
public abstract class AccessStoreContract {
    private static final Instant NOW = Instant.parse("2026-03-04T05:06:07.5Z");
    private static final User ALICE = new User("alice", Role.ADMINISTRATOR, "salt$hash", true);
    private static final User BOB = new User("bob", Role.VIEWER, "salt$other", false);

    private AccessStore store;

    /** An empty store. */
    protected abstract AccessStore emptyStore();

    @BeforeEach
    void open() {
        store = emptyStore();
    }

    @Test
    void givesBackUsersByName() {
        assertThat(store.users()).isEmpty();
        assertThat(store.addUser(BOB)).isTrue();
        assertThat(store.addUser(ALICE)).isTrue();
        assertThat(store.users()).containsExactly(ALICE, BOB);
        assertThat(store.user("alice")).contains(ALICE);
        assertThat(store.user("carol")).isEmpty();
    }

    @Test
    void refusesANameThatIsTaken() {
        store.addUser(ALICE);
        assertThat(store.addUser(new User("alice", Role.VIEWER, "x", false))).isFalse();
        assertThat(store.user("alice")).contains(ALICE);
    }

    @Test
    void updatesAUserAndRefusesOneThatIsNotThere() {
        store.addUser(ALICE);
        User changed = new User("alice", Role.OPERATOR, "new$hash", false);
        store.updateUser(changed);
        assertThat(store.users()).containsExactly(changed);
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
        assertThat(store.users()).containsExactly(BOB);
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
        for (int i = 0; i <= SignInLimit.PER_USER; i++) {
            store.addSignIn(new SignIn("token-" + i, "alice", NOW.plusSeconds(60 + i)));
        }
        assertThat(store.signIn("token-0", NOW)).isEmpty();
        assertThat(store.signIn("token-1", NOW)).isPresent();
        assertThat(store.signIn("token-" + SignInLimit.PER_USER, NOW)).isPresent();
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

    private static AccessKey key(String id, String owner, String secretHash) {
        return new AccessKey(id, "script of " + owner, owner, Role.OPERATOR, secretHash, NOW);
    }
}
