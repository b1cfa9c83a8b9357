package org.dronemap.ws.key;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Clock;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.UUID;
import java.util.stream.Collectors;
import org.dronemap.core.access.AccessKey;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.KeyRights;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.zone.FlightBounds;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.account.AccountChanges;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ServerProblem;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.NameRules;
import org.dronemap.ws.reading.SecretGenerator;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/**
 * Creates, lists, renews and deletes the access keys with which programs of a user sign in. Who comes by a key sees,
 * makes, renews and removes only what was made from it. Any thread.
 */
public final class AccessKeyService {
    private static final int MOST_OF_ONE_OWNER = 200;

    private final AccessStore store;
    private final AccountChanges accounts;
    private final SecretGenerator secrets;
    private final Clock clock;

    /** All keys of one user. */
    @Schema(name = "AccessKeys")
    public record Keys(List<AccessKeyView> accessKeys) {}

    public AccessKeyService(AccessStore store, AccountChanges accounts, SecretGenerator secrets, Clock clock) {
        this.store = store;
        this.accounts = accounts;
        this.secrets = secrets;
        this.clock = clock;
    }

    public List<AccessKeyView> keys(Principal principal) {
        Set<String> within = within(principal);
        return store.accessKeys(principal.name()).stream()
                .filter(key -> within.contains(key.id()))
                .map(key -> AccessKeyView.of(key, null))
                .toList();
    }

    /** Those of a user, for an administrator. */
    public List<AccessKeyView> keysOf(Principal principal, String user) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        return store.accessKeys(accounts.find(principal, user).name()).stream()
                .map(key -> AccessKeyView.of(key, null))
                .toList();
    }

    /** A user's, by an administrator, with all keys that were made from it. */
    public void deleteKeyOf(Principal principal, String user, String id) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        remove(accounts.find(principal, user).name(), id);
    }

    /** A key made with a key stays within it, and goes with it. */
    public AccessKeyView addKey(Principal principal, AccessKeyRequest request) {
        if (store.user(principal.name()).isEmpty()) {
            throw Rejection.of(AccessProblem.NO_OWN_ACCOUNT, "Only a user can own access keys; sign in as one.");
        }
        if (store.accessKeys(principal.name()).size() >= MOST_OF_ONE_OWNER) {
            throw Rejection.of(
                    ServerProblem.LIMIT_REACHED,
                    "You have " + MOST_OF_ONE_OWNER + " access keys; remove some first.",
                    ProblemParameter.WHAT.is("access keys"),
                    ProblemParameter.MOST.is(MOST_OF_ONE_OWNER));
        }
        Instant now = clock.instant();
        KeyRights widest = widest(principal);
        KeyRights rights = request.rights(widest, now);
        rights.beyond(widest).ifPresent(excess -> {
            throw refusal(excess, principal);
        });
        String secret = secrets.token();
        AccessKey key = new AccessKey(
                UUID.randomUUID().toString(),
                NameRules.checked("label", request.label(), AccessKeyRequest.LONGEST_LABEL),
                principal.name(),
                principal.key(),
                rights,
                SecretGenerator.hash(secret),
                now,
                null);
        store.addAccessKey(key);
        return AccessKeyView.of(key, secret);
    }

    /** The same key with a new secret; the old one is void at once, keys made from it stay. */
    public AccessKeyView renew(Principal principal, String id) {
        AccessKey key = find(principal, id);
        String secret = secrets.token();
        if (!store.replaceSecret(principal.name(), id, SecretGenerator.hash(secret))) {
            throw Rejection.unknown(NotFoundProblem.ACCESS_KEY, id);
        }
        accounts.notifyListeners(principal.name());
        return AccessKeyView.of(key, secret);
    }

    /** With all keys that were made from it. */
    public void deleteKey(Principal principal, String id) {
        remove(principal.name(), find(principal, id).id());
    }

    private void remove(String owner, String id) {
        if (!store.deleteAccessKey(owner, id)) {
            throw Rejection.unknown(NotFoundProblem.ACCESS_KEY, id);
        }
        accounts.notifyListeners(owner);
    }

    private AccessKey find(Principal principal, String id) {
        Set<String> within = within(principal);
        return store.accessKeys(principal.name()).stream()
                .filter(key -> key.id().equals(id) && within.contains(id))
                .findFirst()
                .orElseThrow(() -> Rejection.unknown(NotFoundProblem.ACCESS_KEY, id));
    }

    /** The key that was shown and all made from it; without one, all of the user's. */
    private Set<String> within(Principal principal) {
        List<AccessKey> all = store.accessKeys(principal.name());
        Set<String> within = new LinkedHashSet<>();
        String shown = principal.key();
        if (shown == null) {
            all.forEach(key -> within.add(key.id()));
            return within;
        }
        Deque<String> next = new ArrayDeque<>(List.of(shown));
        while (!next.isEmpty()) {
            String parent = next.remove();
            if (within.add(parent)) {
                all.stream().filter(key -> parent.equals(key.parent())).forEach(key -> next.add(key.id()));
            }
        }
        return within;
    }

    private KeyRights widest(Principal principal) {
        return new KeyRights(principal.role(), principal.scope(), expiry(principal));
    }

    private @Nullable Instant expiry(Principal principal) {
        return store.accessKeys(principal.name()).stream()
                .filter(key -> key.id().equals(principal.key()))
                .findFirst()
                .map(key -> key.rights().expiresAt())
                .orElse(null);
    }

    private static Rejection refusal(KeyRights.Excess excess, Principal principal) {
        return switch (excess) {
            case ROLE ->
                Rejection.of(
                        AccessProblem.KEY_TOO_WIDE,
                        "A key cannot do more than its owner, who is " + WireNames.camel(principal.role()) + ".",
                        ProblemParameter.CLOSED_BY.is("role"));
            case DRONES ->
                Rejection.of(
                        AccessProblem.KEY_TOO_WIDE,
                        "A key made with this one cannot reach drones other than " + drones(principal) + ".",
                        ProblemParameter.CLOSED_BY.is("drones"));
            case PERMISSIONS ->
                Rejection.of(
                        AccessProblem.KEY_TOO_WIDE,
                        "A key made with this one can do no more than " + operations(principal) + ".",
                        ProblemParameter.CLOSED_BY.is("operations"));
            case AREA -> beyond(AccessKeyArea.FIELD, "within " + area(principal));
            case ALTITUDE -> beyond("ceiling", heights(principal));
            case EXPIRY ->
                Rejection.of(
                        AccessProblem.KEY_TOO_WIDE,
                        "A key made with this one cannot last longer than it.",
                        ProblemParameter.CLOSED_BY.is("expiry"));
        };
    }

    private static Rejection beyond(String field, String allowed) {
        return new InvalidInput(
                ValueProblem.KEY_BOUNDS_TOO_WIDE,
                field,
                allowed,
                "\"" + field + "\" of a key made with this one must be " + allowed + ".");
    }

    private static String area(Principal principal) {
        FlightBounds bounds = principal.scope().innermost();
        FenceArea area = bounds == null ? null : bounds.area();
        return area == null ? "reach" : AccessKeyArea.words(area);
    }

    private static String heights(Principal principal) {
        FlightBounds bounds = principal.scope().innermost();
        return bounds == null ? "any" : bounds.band().words();
    }

    private static String drones(Principal principal) {
        Set<DroneId> drones = principal.scope().drones();
        return drones == null
                ? "all"
                : drones.stream().map(DroneId::value).sorted().collect(Collectors.joining(", "));
    }

    private static String operations(Principal principal) {
        return principal.scope().permissions().stream().map(WireNames::camel).collect(Collectors.joining(", "));
    }
}
