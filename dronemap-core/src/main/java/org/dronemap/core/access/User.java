package org.dronemap.core.access;

/**
 * A person; the password only as a salted hash.
 *
 * @param mustChangePassword the password is one that somebody else has seen
 */
public record User(String name, Role role, AccountState state, String passwordHash, boolean mustChangePassword) {

    /** Only an active user may do anything at all. */
    public boolean isActive() {
        return state == AccountState.ACTIVE;
    }

    public User withRole(Role newRole) {
        return new User(name, newRole, state, passwordHash, mustChangePassword);
    }

    public User withState(AccountState newState) {
        return new User(name, role, newState, passwordHash, mustChangePassword);
    }

    public User withPassword(String newHash, boolean seenByOthers) {
        return new User(name, role, state, newHash, seenByOthers);
    }
}
