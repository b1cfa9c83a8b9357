package org.dronemap.core.access;

import org.dronemap.core.organisation.OrganisationId;
import org.jspecify.annotations.Nullable;

/**
 * A user account: name, role, state, organisation and a salted hash of the password. What a person owns belongs to the
 * id: names are used again.
 *
 * @param mustChangePassword the password is one that somebody else has seen
 * @param organisation where the user belongs, for ever
 * @param id given by the store, and never again to anybody else; null: not stored yet
 */
public record User(
        String name,
        Role role,
        AccountState state,
        String passwordHash,
        boolean mustChangePassword,
        OrganisationId organisation,
        @Nullable String id) {
    /** A new one. */
    public User(
            String name,
            Role role,
            AccountState state,
            String passwordHash,
            boolean mustChangePassword,
            OrganisationId organisation) {
        this(name, role, state, passwordHash, mustChangePassword, organisation, null);
    }

    /** A new one of the default organisation. */
    public User(String name, Role role, AccountState state, String passwordHash, boolean mustChangePassword) {
        this(name, role, state, passwordHash, mustChangePassword, OrganisationId.HOME);
    }

    /** What owned things name. */
    public String account() {
        return id == null ? name : id;
    }

    public User withId(String given) {
        return new User(name, role, state, passwordHash, mustChangePassword, organisation, given);
    }

    /** Only an active user may do anything at all. */
    public boolean isActive() {
        return state == AccountState.ACTIVE;
    }

    public User withRole(Role newRole) {
        return new User(name, newRole, state, passwordHash, mustChangePassword, organisation, id);
    }

    public User withState(AccountState newState) {
        return new User(name, role, newState, passwordHash, mustChangePassword, organisation, id);
    }

    public User withPassword(String newHash, boolean seenByOthers) {
        return new User(name, role, state, newHash, seenByOthers, organisation, id);
    }
}
