package org.dronemap.store;

import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.dronemap.core.access.AccessKey;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.Invitation;
import org.dronemap.core.access.SignIn;
import org.dronemap.core.access.User;
import org.dronemap.core.time.FatalErrors;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Access store that serves known users, sessions and keys from a cache while the database is out of reach. Every change
 * of an account forgets all of that, whether the change succeeded or not; nothing can be changed while the store is
 * away. A store that hangs counts as away after a second, for whoever is remembered. At most 1,000 accounts, sessions
 * and keys each. Thread-safe.
 */
public final class CachedAccessStore implements AccessStore {
    private static final Logger LOG = LoggerFactory.getLogger(CachedAccessStore.class);
    private static final int MOST = 1_000;
    /** A store that is away takes its time to say so: it is not asked each time. */
    private static final long BETWEEN_QUESTIONS_NANOS = 1_000_000_000L;

    /** So long a store that may be in trouble is asked for somebody who is remembered. */
    private static final Duration PATIENCE = Duration.ofSeconds(1);

    private static final int MOST_QUESTIONS = 8;

    private final AccessStore store;
    private final LongSupplier nanoTime;
    private final ExecutorService queryExecutor;
    private final Map<String, User> users = bounded();
    private final Map<String, SignIn> signIns = bounded();
    private final Map<String, AccessKey> keys = bounded();
    private @Nullable List<User> everybody;
    /** Rises when everything is forgotten: what was read before is not remembered after. Guarded by this. */
    private long generation;
    /** When it was found to be away, last; null: never. Guarded by this. */
    private @Nullable Long awayNanos;

    /** {@code nanoTime} is monotonic. */
    public CachedAccessStore(AccessStore store, LongSupplier nanoTime) {
        this.store = store;
        this.nanoTime = nanoTime;
        this.queryExecutor = queryExecutor();
    }

    /** They end when nothing was asked for a while. */
    private static ExecutorService queryExecutor() {
        ThreadPoolExecutor threads = new ThreadPoolExecutor(
                MOST_QUESTIONS, MOST_QUESTIONS, 10, TimeUnit.SECONDS, new ArrayBlockingQueue<>(MOST), work -> {
                    Thread thread = FatalErrors.onDuty(new Thread(work, "access"));
                    thread.setDaemon(true);
                    return thread;
                });
        threads.allowCoreThreadTimeOut(true);
        return threads;
    }

    private static <T> Map<String, T> bounded() {
        return new LinkedHashMap<>(16, 0.75f, true) {
            private static final long serialVersionUID = 1L;

            @Override
            protected boolean removeEldestEntry(Map.Entry<String, T> eldest) {
                return size() > MOST;
            }
        };
    }

    @Override
    public List<User> users() {
        List<User> known = known(() -> everybody);
        if (known != null) {
            return known;
        }
        long began = now();
        try {
            List<User> read = store.users();
            rememberAll(read, began);
            return read;
        } catch (StoreException failed) {
            return remembered(failed, () -> everybody);
        }
    }

    private synchronized void rememberAll(List<User> read, long began) {
        everybody = began == generation ? List.copyOf(read) : null;
    }

    @Override
    public Optional<User> user(String name) {
        return read(users, name, () -> store.user(name));
    }

    @Override
    public Optional<SignIn> signIn(String tokenHash, Instant now) {
        return read(signIns, tokenHash, () -> store.signIn(tokenHash, now))
                .filter(signIn -> signIn.expiresAt().isAfter(now));
    }

    @Override
    public Optional<AccessKey> accessKey(String secretHash) {
        return read(keys, secretHash, () -> store.accessKey(secretHash));
    }

    private <T> Optional<T> read(Map<String, T> from, String key, Supplier<Optional<T>> asked) {
        T known = known(() -> from.get(key));
        if (known != null) {
            return Optional.of(known);
        }
        if (last(() -> from.get(key)) == null) {
            return ask(from, key, asked);
        }
        Optional<Optional<T>> answer = withTimeout(() -> ask(from, key, asked));
        if (answer.isPresent()) {
            return answer.get();
        }
        // It may have been forgotten meanwhile, for a change.
        T last = last(() -> from.get(key));
        return last == null ? ask(from, key, asked) : Optional.of(last);
    }

    private <T> Optional<T> ask(Map<String, T> from, String key, Supplier<Optional<T>> asked) {
        long began = now();
        try {
            Optional<T> read = asked.get();
            remember(from, key, read.orElse(null), began);
            return read;
        } catch (StoreException failed) {
            return Optional.of(remembered(failed, () -> from.get(key)));
        }
    }

    /** The answer, unless the store does not give one soon: whoever is remembered must not wait for a store that hangs. */
    private <T> Optional<T> withTimeout(Callable<T> question) {
        Future<T> answer;
        try {
            answer = queryExecutor.submit(question);
        } catch (RejectedExecutionException e) {
            return markAway(e);
        }
        try {
            return Optional.of(answer.get(PATIENCE.toNanos(), TimeUnit.NANOSECONDS));
        } catch (TimeoutException e) {
            return markAway(e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return markAway(e);
        } catch (ExecutionException e) {
            if (e.getCause() instanceof RuntimeException failed) {
                throw failed;
            }
            throw new IllegalStateException(e);
        }
    }

    private synchronized <T> Optional<T> markAway(Exception why) {
        LOG.warn("The store does not say who may do what; who was recognised lately is recognised from memory", why);
        awayNanos = nanoTime.getAsLong();
        return Optional.empty();
    }

    private synchronized <T> @Nullable T last(Supplier<@Nullable T> known) {
        return known.get();
    }

    private synchronized <T> void remember(Map<String, T> in, String key, @Nullable T read, long began) {
        if (read == null || began != generation) {
            in.remove(key);
        } else {
            in.put(key, read);
        }
    }

    /** What is remembered while the store was away a moment ago; null: ask it. */
    private synchronized <T> @Nullable T known(Supplier<@Nullable T> known) {
        boolean wasAway = awayNanos != null && nanoTime.getAsLong() - awayNanos < BETWEEN_QUESTIONS_NANOS;
        return wasAway ? known.get() : null;
    }

    /** Fails as the store did where nothing is remembered, or where it is not only away. */
    private synchronized <T> T remembered(StoreException failed, Supplier<@Nullable T> known) {
        T last = failed.isTransient() ? known.get() : null;
        if (last == null) {
            throw failed;
        }
        awayNanos = nanoTime.getAsLong();
        return last;
    }

    private synchronized long now() {
        return generation;
    }

    private synchronized void clear() {
        generation++;
        users.clear();
        signIns.clear();
        keys.clear();
        everybody = null;
    }

    /** What is read while it changes is not remembered either. */
    private <T> T changing(Supplier<T> change) {
        clear();
        try {
            return change.get();
        } finally {
            clear();
        }
    }

    private void changing(Runnable change) {
        changing(() -> {
            change.run();
            return true;
        });
    }

    @Override
    public boolean addUser(User user) {
        return changing(() -> store.addUser(user));
    }

    @Override
    public void updateUser(User user) {
        changing(() -> store.updateUser(user));
    }

    @Override
    public boolean deleteUser(String name) {
        return changing(() -> store.deleteUser(name));
    }

    /** A new session changes nothing that is remembered. */
    @Override
    public void addSignIn(SignIn signIn) {
        store.addSignIn(signIn);
    }

    @Override
    public void deleteSignIn(String tokenHash) {
        changing(() -> store.deleteSignIn(tokenHash));
    }

    @Override
    public void deleteOtherSignIns(String user, String keepTokenHash) {
        changing(() -> store.deleteOtherSignIns(user, keepTokenHash));
    }

    @Override
    public List<AccessKey> accessKeys(String owner) {
        return store.accessKeys(owner);
    }

    @Override
    public void addAccessKey(AccessKey key) {
        store.addAccessKey(key);
    }

    @Override
    public boolean replaceSecret(String owner, String id, String secretHash) {
        return changing(() -> store.replaceSecret(owner, id, secretHash));
    }

    /** Not worth refusing anything for, nor waiting. */
    @Override
    public void accessKeyUsed(String id, Instant at) {
        Optional<Boolean> written = withTimeout(() -> isWritten(id, at));
        if (!written.orElse(false)) {
            LOG.info("That the key {} was used is not written down: the store is away", id);
        }
    }

    private boolean isWritten(String id, Instant at) {
        try {
            store.accessKeyUsed(id, at);
            return true;
        } catch (StoreException failed) {
            if (!failed.isTransient()) {
                throw failed;
            }
            return false;
        }
    }

    @Override
    public boolean deleteAccessKey(String owner, String id) {
        return changing(() -> store.deleteAccessKey(owner, id));
    }

    @Override
    public List<Invitation> invitations(Instant now) {
        return store.invitations(now);
    }

    @Override
    public void addInvitation(Invitation invitation, Instant now) {
        store.addInvitation(invitation, now);
    }

    @Override
    public boolean deleteInvitation(String id) {
        return store.deleteInvitation(id);
    }

    @Override
    public Optional<Invitation> invitation(String codeHash, Instant now) {
        return store.invitation(codeHash, now);
    }

    @Override
    public boolean acceptInvitation(String invitationId, User user) {
        return changing(() -> store.acceptInvitation(invitationId, user));
    }
}
