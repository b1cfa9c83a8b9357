package org.dronemap.core.access;

import java.time.Instant;
import java.util.List;
import java.util.Optional;

/** Keeps users, their sessions and access keys; every write returns only after it is durable. */
public interface AccessStore {
    List<User> users();

    Optional<User> user(String name);

    /** False when the name is taken. */
    boolean addUser(User user);

    void updateUser(User user);

    /** Removes the user with sessions and keys; true when there was one. */
    boolean deleteUser(String name);

    void addSignIn(SignIn signIn);

    /** Only when it has not expired at {@code now}. */
    Optional<SignIn> signIn(String tokenHash, Instant now);

    void deleteSignIn(String tokenHash);

    /** Ends every session of a user but the one named. */
    void deleteOtherSignIns(String user, String keepTokenHash);

    List<AccessKey> accessKeys(String owner);

    Optional<AccessKey> accessKey(String secretHash);

    void addAccessKey(AccessKey key);

    /** True when that owner had such a key. */
    boolean deleteAccessKey(String owner, String id);
}
