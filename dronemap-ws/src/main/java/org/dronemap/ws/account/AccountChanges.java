package org.dronemap.ws.account;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.User;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.Rejection;

/**
 * Changes user accounts one at a time, so that two administrators cannot remove each other and leave none. After each
 * change whoever is connected as that user is judged anew. Any thread.
 */
public final class AccountChanges {
    private final AccessStore store;
    private final List<Consumer<String>> listeners = new CopyOnWriteArrayList<>();

    public AccountChanges(AccessStore store) {
        this.store = store;
    }

    /** Is told the name of each user whose rights may have changed, when the change is durable. */
    public void onChange(Consumer<String> listener) {
        listeners.add(listener);
    }

    /** The same, before all others: who acts by rights that are gone must not do so on what the others free. */
    public void onChangeFirst(Consumer<String> listener) {
        listeners.add(0, listener);
    }

    /**
     * A new user, unless the name is one's already, or cannot be told from it.
     *
     * @param keeps keeps the user; false when the name is taken
     */
    public synchronized boolean add(User user, Predicate<User> keeps) {
        boolean taken = store.users().stream().anyMatch(known -> UserNameRules.lookAlike(known.name(), user.name()));
        return !taken && keeps.test(user);
    }

    /** What nobody may do to themself, so that an administrator is left. */
    public void changeOther(Principal actor, String name, UnaryOperator<User> change) {
        changeOther(actor, name, () -> store.updateUser(change.apply(find(actor, name))));
    }

    /** Ends the user's sessions as well. */
    public void changeOtherAndSignOut(Principal actor, String name, UnaryOperator<User> change) {
        changeOther(actor, name, () -> {
            store.updateUser(change.apply(find(actor, name)));
            store.deleteOtherSignIns(name, "");
        });
    }

    public void delete(Principal actor, String name) {
        changeOther(actor, name, () -> {
            if (!store.deleteUser(find(actor, name).name())) {
                throw Rejection.unknown(NotFoundProblem.USER, name);
            }
        });
    }

    /** A user's own change, which takes no rights from others. */
    public void changeOwn(String name, UnaryOperator<User> change, String keepTokenHash) {
        synchronized (this) {
            store.updateUser(
                    change.apply(store.user(name).orElseThrow(() -> Rejection.unknown(NotFoundProblem.USER, name))));
            store.deleteOtherSignIns(name, keepTokenHash);
        }
        notifyListeners(name);
    }

    /** Sessions or keys of that user have been taken away. */
    public void notifyListeners(String name) {
        listeners.forEach(listener -> listener.accept(name));
    }

    /** Users of other organisations are not there. */
    public User find(Principal actor, String name) {
        return store.user(name)
                .filter(user -> user.organisation().equals(actor.organisation()))
                .orElseThrow(() -> Rejection.unknown(NotFoundProblem.USER, name));
    }

    private void changeOther(Principal actor, String name, Runnable change) {
        if (actor.name().equals(name)) {
            throw Rejection.of(
                    AccessProblem.NOT_TO_ONESELF, "You cannot do this to yourself; ask another administrator.");
        }
        synchronized (this) {
            // Rights may have gone since the request was admitted.
            boolean still = store.user(actor.name())
                    .filter(User::isActive)
                    .map(user -> user.role().includes(Role.ADMINISTRATOR))
                    .orElse(false);
            if (!still) {
                throw Rejection.of(AccessProblem.ROLE_CHANGED, "You are no longer an administrator.");
            }
            change.run();
        }
        notifyListeners(name);
    }
}
