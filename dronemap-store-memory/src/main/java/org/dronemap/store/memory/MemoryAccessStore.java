package org.dronemap.store.memory;

import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.dronemap.core.access.AccessKey;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.Invitation;
import org.dronemap.core.access.KeyRights;
import org.dronemap.core.access.SignIn;
import org.dronemap.core.access.User;
import org.dronemap.store.StoreException;
import org.dronemap.store.StoredInstant;
import org.dronemap.store.UserSessionLimit;
import org.jspecify.annotations.Nullable;

/**
 * Keeps users, their sessions and access keys in memory, for tests. Thread-safe: every method holds the object's lock.
 */
public final class MemoryAccessStore implements AccessStore {
    private final Map<String, User> users = new TreeMap<>();
    private final Map<String, SignIn> signIns = new HashMap<>();
    private final Map<String, AccessKey> keys = new HashMap<>();
    private final Map<String, Invitation> invitations = new HashMap<>();
    private long lastId;

    @Override
    public synchronized List<User> users() {
        return List.copyOf(users.values());
    }

    @Override
    public synchronized Optional<User> user(String name) {
        return Optional.ofNullable(users.get(name));
    }

    @Override
    public synchronized boolean addUser(User user) {
        return users.putIfAbsent(user.name(), user.withId("#" + ++lastId)) == null;
    }

    @Override
    public synchronized void updateUser(User user) {
        requireUser(user.name());
        users.put(user.name(), user);
    }

    @Override
    public synchronized boolean deleteUser(String name) {
        signIns.values().removeIf(signIn -> signIn.user().equals(name));
        keys.values().removeIf(key -> key.owner().equals(name));
        return users.remove(name) != null;
    }

    @Override
    public synchronized void addSignIn(SignIn signIn) {
        requireUser(signIn.user());
        if (signIns.containsKey(signIn.tokenHash())) {
            throw new StoreException("That session exists already.");
        }
        signIns.values().stream()
                .filter(other -> other.user().equals(signIn.user()))
                .sorted(Comparator.comparing(SignIn::expiresAt).reversed().thenComparing(SignIn::tokenHash))
                .skip(UserSessionLimit.PER_USER - 1L)
                .toList()
                .forEach(surplus -> signIns.remove(surplus.tokenHash()));
        signIns.put(
                signIn.tokenHash(),
                new SignIn(signIn.tokenHash(), signIn.user(), StoredInstant.of(signIn.expiresAt())));
    }

    @Override
    public synchronized Optional<SignIn> signIn(String tokenHash, Instant now) {
        return Optional.ofNullable(signIns.get(tokenHash))
                .filter(signIn -> signIn.expiresAt().isAfter(StoredInstant.of(now)));
    }

    @Override
    public synchronized void deleteSignIn(String tokenHash) {
        signIns.remove(tokenHash);
    }

    @Override
    public synchronized void deleteOtherSignIns(String user, String keepTokenHash) {
        signIns.values()
                .removeIf(signIn ->
                        signIn.user().equals(user) && !signIn.tokenHash().equals(keepTokenHash));
    }

    @Override
    public synchronized List<AccessKey> accessKeys(String owner) {
        return keys.values().stream()
                .filter(key -> key.owner().equals(owner))
                .sorted(Comparator.comparing(AccessKey::createdAt).thenComparing(AccessKey::id))
                .toList();
    }

    @Override
    public synchronized Optional<AccessKey> accessKey(String secretHash) {
        return keys.values().stream()
                .filter(key -> key.secretHash().equals(secretHash))
                .findFirst();
    }

    @Override
    public synchronized void addAccessKey(AccessKey key) {
        requireUser(key.owner());
        if (keys.containsKey(key.id()) || accessKey(key.secretHash()).isPresent()) {
            throw new StoreException("That access key exists already.");
        }
        if (key.parent() != null && !keys.containsKey(key.parent())) {
            throw new StoreException("The access key that it is made from is not there.");
        }
        keys.put(key.id(), stored(key, key.secretHash(), key.lastUsedAt()));
    }

    @Override
    public synchronized boolean replaceSecret(String owner, String id, String secretHash) {
        AccessKey key = keys.get(id);
        if (key == null || !key.owner().equals(owner)) {
            return false;
        }
        keys.put(id, stored(key, secretHash, key.lastUsedAt()));
        return true;
    }

    @Override
    public synchronized void accessKeyUsed(String id, Instant at) {
        AccessKey key = keys.get(id);
        if (key != null && (key.lastUsedAt() == null || key.lastUsedAt().isBefore(at))) {
            keys.put(id, stored(key, key.secretHash(), at));
        }
    }

    private static AccessKey stored(AccessKey key, String secretHash, @Nullable Instant lastUsedAt) {
        KeyRights rights = key.rights();
        return new AccessKey(
                key.id(),
                key.label(),
                key.owner(),
                key.parent(),
                new KeyRights(rights.role(), rights.scope(), storedOrNull(rights.expiresAt())),
                secretHash,
                StoredInstant.of(key.createdAt()),
                storedOrNull(lastUsedAt));
    }

    private static @Nullable Instant storedOrNull(@Nullable Instant time) {
        return time == null ? null : StoredInstant.of(time);
    }

    @Override
    public synchronized boolean deleteAccessKey(String owner, String id) {
        AccessKey key = keys.get(id);
        if (key == null || !key.owner().equals(owner)) {
            return false;
        }
        Deque<String> going = new ArrayDeque<>(List.of(id));
        while (!going.isEmpty()) {
            String next = going.remove();
            keys.remove(next);
            keys.values().stream().filter(child -> next.equals(child.parent())).forEach(child -> going.add(child.id()));
        }
        return true;
    }

    @Override
    public synchronized List<Invitation> invitations(Instant now) {
        return invitations.values().stream()
                .filter(invitation -> invitation.expiresAt().isAfter(StoredInstant.of(now)))
                .sorted(Comparator.comparing(Invitation::expiresAt).thenComparing(Invitation::id))
                .toList();
    }

    @Override
    public synchronized void addInvitation(Invitation invitation, Instant now) {
        invitations.values().removeIf(other -> !other.expiresAt().isAfter(StoredInstant.of(now)));
        if (invitations.containsKey(invitation.id())) {
            throw new StoreException("That invitation exists already.");
        }
        invitations.put(
                invitation.id(),
                new Invitation(
                        invitation.id(),
                        invitation.label(),
                        invitation.role(),
                        invitation.codeHash(),
                        invitation.invitedBy(),
                        invitation.account(),
                        StoredInstant.of(invitation.expiresAt()),
                        invitation.organisation()));
    }

    @Override
    public synchronized boolean deleteInvitation(String id) {
        return invitations.remove(id) != null;
    }

    @Override
    public synchronized Optional<Invitation> invitation(String codeHash, Instant now) {
        return invitations(now).stream()
                .filter(invitation -> invitation.codeHash().equals(codeHash))
                .findFirst();
    }

    @Override
    public synchronized boolean acceptInvitation(String invitationId, User user) {
        if (!invitations.containsKey(invitationId) || !addUser(user)) {
            return false;
        }
        invitations.remove(invitationId);
        return true;
    }

    private void requireUser(String name) {
        if (!users.containsKey(name)) {
            throw new StoreException("There is no user " + name + ".");
        }
    }
}
