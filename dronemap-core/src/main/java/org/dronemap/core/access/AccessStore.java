package org.dronemap.core.access;

import java.time.Instant;
import java.util.List;
import java.util.Optional;

/**
 * Stores user accounts, browser sessions, access keys and invitations; every write returns only after it is durable.
 */
public interface AccessStore {
    List<User> users();

    Optional<User> user(String name);

    /** Gives the user an id that nobody had before; false when the name is taken. */
    boolean addUser(User user);

    void updateUser(User user);

    /** Removes the user with sessions and keys; true when there was one. */
    boolean deleteUser(String name);

    void addSignIn(SignIn signIn);

    /** Only when it has not expired at {@code now}. */
    Optional<SignIn> signIn(String tokenHash, Instant now);

    void deleteSignIn(String tokenHash);

    /** Ends every session of a user but the one named; an empty name keeps none. */
    void deleteOtherSignIns(String user, String keepTokenHash);

    List<AccessKey> accessKeys(String owner);

    Optional<AccessKey> accessKey(String secretHash);

    /** Its parent, when it has one, must be there. */
    void addAccessKey(AccessKey key);

    /** The same key with another secret; true when that owner had such a key. */
    boolean replaceSecret(String owner, String id, String secretHash);

    /** An earlier time than the one kept, or a key that is gone, changes nothing. */
    void accessKeyUsed(String id, Instant at);

    /** With all keys made from it; true when that owner had such a key. */
    boolean deleteAccessKey(String owner, String id);

    /** Those that have not expired at {@code now}, the one that expires first before the others. */
    List<Invitation> invitations(Instant now);

    /** Forgets those that have expired at {@code now}, too. */
    void addInvitation(Invitation invitation, Instant now);

    /** True when there was one. */
    boolean deleteInvitation(String id);

    Optional<Invitation> invitation(String codeHash, Instant now);

    /** The user is there and the invitation used up, or, when either cannot be, neither: then false. */
    boolean acceptInvitation(String invitationId, User user);
}
