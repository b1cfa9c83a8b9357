package org.dronemap.core.access;

import org.dronemap.core.organisation.OrganisationId;

/**
 * A person; the password only as a salted hash.
 *
 * @param mustChangePassword the password is one that somebody else has seen
 * @param organisation where the user belongs, for ever
 */
public record User(
        String name,
        Role role,
        AccountState state,
        String passwordHash,
        boolean mustChangePassword,
        OrganisationId organisation) {
    /** Of the default organisation. */
    public User(String name, Role role, AccountState state, String passwordHash, boolean mustChangePassword) {
        this(name, role, state, passwordHash, mustChangePassword, OrganisationId.HOME);
    }

    /** Only an active user may do anything at all. */
    public boolean isActive() {
        return state == AccountState.ACTIVE;
    }

    public User withRole(Role newRole) {
        return new User(name, newRole, state, passwordHash, mustChangePassword, organisation);
    }

    public User withState(AccountState newState) {
        return new User(name, role, newState, passwordHash, mustChangePassword, organisation);
    }

    public User withPassword(String newHash, boolean seenByOthers) {
        return new User(name, role, state, newHash, seenByOthers, organisation);
    }
}
