package org.dronemap.ws.service;

import java.time.Clock;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.UUID;
import org.dronemap.core.access.AccessKey;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.jspecify.annotations.Nullable;

/** Access keys of users, for programs. Any thread. */
public final class AccessKeyService {
    private final AccessStore store;
    private final Accounts accounts;
    private final Secrets secrets;
    private final Clock clock;

    /** A new access key as its owner asks for it; the role is the owner's own unless a lesser one is named. */
    public record KeyRequest(
            @Nullable String label, @Nullable String role) {}

    /** An access key as its owner sees it; the key itself is there once, in the answer that made it. */
    public record KeyView(
            String id,
            String label,
            String role,
            Instant createdAt,
            @Nullable String key) {}

    public AccessKeyService(AccessStore store, Accounts accounts, Secrets secrets, Clock clock) {
        this.store = store;
        this.accounts = accounts;
        this.secrets = secrets;
        this.clock = clock;
    }

    public List<KeyView> keys(Principal principal) {
        return store.accessKeys(principal.name()).stream()
                .map(key -> view(key, null))
                .toList();
    }

    public KeyView addKey(Principal principal, KeyRequest request) {
        if (store.user(principal.name()).isEmpty()) {
            throw Rejection.forbidden("Only a user can own access keys; sign in as one.");
        }
        Role role = request.role() == null ? principal.role() : Roles.named(request.role());
        if (!principal.role().includes(role)) {
            throw Rejection.forbidden(
                    "A key cannot do more than its owner, who is " + WireNames.camel(principal.role()) + ".");
        }
        String secret = secrets.token();
        AccessKey key = new AccessKey(
                UUID.randomUUID().toString(),
                Names.checked("label", request.label(), 60),
                principal.name(),
                role,
                Secrets.hash(secret),
                clock.instant());
        store.addAccessKey(key);
        return view(key, secret);
    }

    public void deleteKey(Principal principal, String id) {
        if (!store.deleteAccessKey(principal.name(), id)) {
            throw Rejection.unknown("access key", id);
        }
        accounts.tell(principal.name());
    }

    private static KeyView view(AccessKey key, @Nullable String secret) {
        return new KeyView(
                key.id(),
                key.label(),
                WireNames.camel(key.role()),
                key.createdAt().truncatedTo(ChronoUnit.MILLIS),
                secret);
    }
}
