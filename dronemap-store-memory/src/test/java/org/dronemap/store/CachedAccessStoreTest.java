package org.dronemap.store;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.AccountState;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.SignIn;
import org.dronemap.core.access.User;
import org.dronemap.store.contract.AccessStoreContract;
import org.dronemap.store.memory.MemoryAccessStore;
import org.junit.jupiter.api.Test;

/** As any store of accounts; and while the one behind it is away it knows whom it knew, and nobody else. */
class CachedAccessStoreTest extends AccessStoreContract {
    private static final Duration PATIENCE = Duration.ofSeconds(30);
    private static final Instant NOW = Instant.parse("2026-03-04T05:06:07Z");
    private static final User ANN = new User("ann", Role.OPERATOR, AccountState.ACTIVE, "salt$hash", false);
    private static final User BOB = new User("bob", Role.OPERATOR, AccountState.ACTIVE, "salt$other", false);

    private final MemoryAccessStore behind = new MemoryAccessStore();
    private final AtomicInteger asked = new AtomicInteger();
    private final AtomicLong nanos = new AtomicLong();
    private final CachedAccessStore access = new CachedAccessStore(behind(), nanos::get);
    private volatile boolean away;
    private volatile CountDownLatch answers = new CountDownLatch(0);

    @Override
    protected AccessStore emptyStore() {
        return new CachedAccessStore(new MemoryAccessStore(), System::nanoTime);
    }

    /** Fails as a database does that cannot be reached. */
    private AccessStore behind() {
        return (AccessStore) Proxy.newProxyInstance(
                AccessStore.class.getClassLoader(), new Class<?>[] {AccessStore.class}, (proxy, method, arguments) -> {
                    asked.incrementAndGet();
                    answers.await();
                    if (away) {
                        throw StoreException.passing("It is away.", new IllegalStateException("no connection"));
                    }
                    try {
                        return method.invoke(behind, arguments);
                    } catch (InvocationTargetException e) {
                        throw e.getCause();
                    }
                });
    }

    private void signedIn(User user, String token) {
        access.addUser(user);
        access.addSignIn(new SignIn(token, user.name(), NOW.plusSeconds(60)));
        assertThat(access.signIn(token, NOW)).isPresent();
        assertThat(access.user(user.name())).map(User::name).contains(user.name());
    }

    @Test
    void knowsWhomItKnewWhileTheStoreIsAway() {
        signedIn(ANN, "token");
        away = true;
        assertThat(access.signIn("token", NOW)).isPresent();
        assertThat(access.user("ann")).map(User::name).contains("ann");
        assertThatThrownBy(() -> access.user("bob")).isInstanceOf(StoreException.class);
    }

    @Test
    void knowsWhomItKnewWhileTheStoreHangs() {
        signedIn(ANN, "token");
        answers = new CountDownLatch(1);

        CompletableFuture<Optional<User>> known = CompletableFuture.supplyAsync(() -> access.user("ann"));
        assertThat(known).succeedsWithin(PATIENCE).isEqualTo(Optional.of(ANN.withId("#1")));
        CompletableFuture<Void> used = CompletableFuture.runAsync(() -> access.accessKeyUsed("key", NOW));
        assertThat(used).succeedsWithin(PATIENCE);

        answers.countDown();
    }

    @Test
    void asksAgainForWhomItForgotWhileTheStoreHung() {
        signedIn(ANN, "token");
        answers = new CountDownLatch(1);
        int before = asked.get();
        CompletableFuture<Optional<User>> known = CompletableFuture.supplyAsync(() -> access.user("ann"));
        await().atMost(PATIENCE).until(() -> asked.get() == before + 1);

        CompletableFuture<Void> changed =
                CompletableFuture.runAsync(() -> access.updateUser(ANN.withState(AccountState.DISABLED)));
        await().atMost(PATIENCE).until(() -> asked.get() == before + 3);
        assertThat(known).as("waits for what is stored").isNotDone();

        answers.countDown();
        assertThat(changed).succeedsWithin(PATIENCE);
        assertThat(known).succeedsWithin(PATIENCE);
    }

    @Test
    void letsASessionEndInItsTimeWhileTheStoreIsAway() {
        signedIn(ANN, "token");
        away = true;
        assertThat(access.signIn("token", NOW.plusSeconds(61))).isEmpty();
    }

    @Test
    void knowsNobodyAnyMoreWhoseAccountOrSessionWasChanged() {
        signedIn(ANN, "token");
        access.updateUser(ANN.withState(AccountState.DISABLED));
        away = true;
        assertThatThrownBy(() -> access.user("ann")).isInstanceOf(StoreException.class);
        assertThatThrownBy(() -> access.signIn("token", NOW)).isInstanceOf(StoreException.class);
    }

    @Test
    void forgetsWhatWasToBeChangedThoughThatFailed() {
        signedIn(ANN, "token");
        away = true;
        assertThatThrownBy(() -> access.deleteSignIn("token")).isInstanceOf(StoreException.class);
        assertThatThrownBy(() -> access.signIn("token", NOW)).isInstanceOf(StoreException.class);
    }

    @Test
    void asksAStoreThatIsAwayOnceASecond() {
        signedIn(ANN, "token");
        away = true;
        access.user("ann");
        int before = asked.get();
        access.user("ann");
        access.signIn("token", NOW);
        assertThat(asked.get()).isEqualTo(before);
        nanos.addAndGet(1_000_000_000L);
        access.user("ann");
        assertThat(asked.get()).isEqualTo(before + 1);
    }

    @Test
    void knowsWhatIsStoredAsSoonAsTheStoreIsBack() {
        signedIn(ANN, "token");
        away = true;
        access.user("ann");
        away = false;
        nanos.addAndGet(1_000_000_000L);
        behind.deleteUser("ann");
        assertThat(access.user("ann")).isEmpty();
        access.addUser(BOB);
        assertThat(access.users()).extracting(User::name).containsExactly("bob");
    }
}
