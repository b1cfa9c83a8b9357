package org.dronemap.store.postgres;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Set;
import org.dronemap.core.access.AccountState;
import org.dronemap.core.access.GrantObject;
import org.dronemap.core.access.GrantStore;
import org.dronemap.core.access.GrantSubject;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.User;
import org.dronemap.core.access.UserGroup;
import org.dronemap.store.StoreException;
import org.dronemap.store.contract.GrantStoreContract;
import org.junit.jupiter.api.Test;

class PostgresGrantStoreTest extends GrantStoreContract {
    private PostgresStores database = SharedDatabase.empty();

    @Override
    protected GrantStore emptyStore() {
        database = SharedDatabase.empty();
        for (String name : USERS) {
            database.access().addUser(new User(name, Role.VIEWER, AccountState.ACTIVE, "x", false));
        }
        return database.grants();
    }

    @Test
    void forgetsWhatAUserWasGrantedWithTheUser() {
        GrantStore store = emptyStore();
        store.save(group("g1", "crew", "ann"));
        store.add(grant("a", new GrantSubject.OfUser("ann"), new GrantObject.Everything()));
        store.setOnlyGranted(new GrantSubject.OfUser("ann"), true);

        database.access().deleteUser("ann");

        assertThat(store.directory().grants()).isEmpty();
        assertThat(store.directory().onlyGranted()).isEmpty();
        assertThat(store.directory().groups()).extracting(UserGroup::members).containsExactly(Set.of());
    }

    @Test
    void keepsAnOrganisationThatHasUsers() {
        GrantStore store = emptyStore();
        store.save(RESCUE);
        database.access().addUser(new User("carl", Role.VIEWER, AccountState.ACTIVE, "x", false, RESCUE.id()));

        assertThatThrownBy(() -> store.deleteOrganisation(RESCUE.id())).isInstanceOf(StoreException.class);
        assertThat(store.directory().organisations()).containsExactly(RESCUE);
    }
}
