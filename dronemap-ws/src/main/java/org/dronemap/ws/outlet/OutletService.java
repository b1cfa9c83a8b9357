package org.dronemap.ws.outlet;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
import jakarta.validation.constraints.Size;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.Duration;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.access.AccessKey;
import org.dronemap.core.access.AccessStore;
import org.dronemap.core.access.KeyScope;
import org.dronemap.core.access.LinkKey;
import org.dronemap.core.access.Permission;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.User;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.account.AccountChanges;
import org.dronemap.ws.problem.AccessProblem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ServerProblem;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.SecretGenerator;
import org.jspecify.annotations.Nullable;

/**
 * Lets users attach third-party ground stations to the outlet: sets passphrases, opens ports and lists clients. Any
 * thread.
 */
public final class OutletService {
    private static final int SHORTEST = 16;
    private static final int LONGEST = 64;
    private static final int MOST_HOURS = 24;
    private static final int USUAL_HOURS = 8;
    private static final String HOURS_FORM = "1 to " + MOST_HOURS;
    private static final String ADDRESS_FORM =
            "an IP address, or a network: at most a /24, of IPv6 a /64 (192.0.2.0/24)";
    private static final String FORM = "16 to 64 printable ASCII characters, without blanks at the ends";

    private final OutletGateway outlet;
    private final AccessStore store;
    private final SecretGenerator secrets;

    /** A passphrase of one's own choice; without one it is made up. */
    @Schema(name = "PassphraseRequest")
    public record PassphraseRequest(
            @Schema(description = FORM) @Size(min = SHORTEST, max = LONGEST) @Nullable
            String passphrase) {

        /** It holds a secret. */
        @Override
        public String toString() {
            return "PassphraseRequest[]";
        }
    }

    /** A passphrase that was just set; this is the only time that it is shown. */
    @Schema(name = "PassphraseView")
    public record PassphraseView(String passphrase) {

        @Override
        public String toString() {
            return "PassphraseView[]";
        }
    }

    /**
     * A port of one's own for a program that cannot sign.
     *
     * @param address from where it may be spoken to: an IP address, or a network
     * @param hours that it shall be open, 1 to 24; without, 8
     */
    @Schema(name = "OutletPortRequest")
    public record PortRequest(
            @Nullable String address,
            @Min(1) @Max(MOST_HOURS) @Nullable Integer hours) {}

    /** One's own side of the outlet. */
    @Schema(name = "OwnOutletView")
    public record OwnOutletView(
            List<String> endpoints,
            boolean passphraseSet,
            List<OutletView.ClientView> clients,
            List<OutletView.PortView> ports) {}

    /** {@code accounts}: a user who is gone takes the passphrase along. */
    public OutletService(OutletGateway outlet, AccessStore store, AccountChanges accounts, SecretGenerator secrets) {
        this.outlet = outlet;
        this.store = store;
        this.secrets = secrets;
        accounts.onChange(this::changed);
    }

    private void changed(String user) {
        Optional<User> known = store.user(user);
        if (outlet.hasKey(user) && known.isEmpty()) {
            outlet.removeKey(user);
        }
        if (known.filter(User::isActive).isEmpty()) {
            outlet.closePortsOf(user);
        }
    }

    public OwnOutletView own(Principal principal) {
        RoleChecks.require(principal, Role.VIEWER);
        OutletView status = outlet.status();
        return new OwnOutletView(
                status.endpoints(),
                outlet.hasKey(principal.name()),
                status.clients().stream()
                        .filter(client -> client.user().equals(principal.name()))
                        .toList(),
                status.ports().stream()
                        .filter(port -> port.user().equals(principal.name()))
                        .toList());
    }

    /** Replaces the one before; programs that use that are disconnected. */
    public PassphraseView setPassphrase(Principal principal, PassphraseRequest request) {
        RoleChecks.require(principal, Role.VIEWER);
        requireAllRights(principal);
        String given = request.passphrase();
        String passphrase = given == null ? secrets.password() : checked(given);
        if (!outlet.putKey(principal.name(), key(passphrase))) {
            throw Rejection.of(AccessProblem.PASSPHRASE_UNUSABLE, "This passphrase cannot be used; take another one.");
        }
        return new PassphraseView(passphrase);
    }

    public void clearPassphrase(Principal principal) {
        RoleChecks.require(principal, Role.VIEWER);
        outlet.removeKey(principal.name());
    }

    /** Opens a port at which a program that cannot sign sees what its user may see, and changes nothing. */
    public OutletView.PortView openPort(Principal principal, PortRequest request) {
        RoleChecks.require(principal, Role.VIEWER);
        requireAllRights(principal);
        String address = request.address();
        if (address == null || address.isBlank()) {
            throw new InvalidInput(
                    ValueProblem.VALUE_MISSING,
                    "address",
                    ADDRESS_FORM,
                    "\"address\" is missing: " + ADDRESS_FORM + ".");
        }
        Integer hours = request.hours();
        if (hours != null && (hours < 1 || hours > MOST_HOURS)) {
            throw new InvalidInput(
                    ValueProblem.VALUE_OUT_OF_RANGE,
                    "hours",
                    HOURS_FORM,
                    "\"hours\" must be " + HOURS_FORM + ".",
                    ProblemParameter.LEAST.is(1),
                    ProblemParameter.MOST.is(MOST_HOURS),
                    ProblemParameter.UNIT.is("hours"));
        }
        try {
            return outlet.openPort(principal.name(), address, Duration.ofHours(hours == null ? USUAL_HOURS : hours));
        } catch (IllegalArgumentException noAddress) {
            throw new InvalidInput(
                    ValueProblem.VALUE_MALFORMED, "address", ADDRESS_FORM, String.valueOf(noAddress.getMessage()));
        } catch (IllegalStateException none) {
            throw Rejection.of(
                    ServerProblem.LIMIT_REACHED,
                    String.valueOf(none.getMessage()),
                    ProblemParameter.WHAT.is("personal ports"));
        }
    }

    /** Closes one's own, or as an administrator of the server anybody's. */
    public void closePort(Principal principal, String id) {
        RoleChecks.require(principal, Role.VIEWER);
        boolean anybodys =
                principal.may(Role.ADMINISTRATOR) && principal.organisation().isHome() && principal.isWhole();
        boolean may = outlet.status().ports().stream()
                .filter(port -> port.id().equals(id))
                .anyMatch(port -> anybodys || port.user().equals(principal.name()));
        if (!may || !outlet.closePort(id)) {
            throw Rejection.unknown(NotFoundProblem.PERSONAL_PORT, id);
        }
    }

    public OutletView all(Principal principal) {
        RoleChecks.requireServer(principal, Role.ADMINISTRATOR);
        return outlet.status();
    }

    public void disconnect(Principal principal, String id) {
        RoleChecks.requireServer(principal, Role.ADMINISTRATOR);
        if (!outlet.disconnect(id)) {
            throw Rejection.unknown(NotFoundProblem.OUTLET_CLIENT, id);
        }
    }

    /** A passphrase lets programs do all that its user may: no key that may less, or ends, can set one. */
    private void requireAllRights(Principal principal) {
        String id = principal.key();
        if (id == null) {
            return;
        }
        boolean whole = store.accessKeys(principal.name()).stream()
                .filter(key -> key.id().equals(id))
                .anyMatch(key -> isWhole(key, store.user(principal.name()).orElse(null)));
        if (!whole) {
            throw Rejection.of(
                    AccessProblem.KEY_LIMITED,
                    "This access key may less than you; sign in with your password to set the passphrase.");
        }
    }

    private static boolean isWhole(AccessKey key, @Nullable User owner) {
        KeyScope scope = key.rights().scope();
        return owner != null
                && key.rights().role().includes(owner.role())
                && key.rights().expiresAt() == null
                && scope.coversAllDrones()
                && !scope.isBounded()
                && scope.permissions().containsAll(EnumSet.allOf(Permission.class));
    }

    private static String checked(String passphrase) {
        boolean printable = passphrase.chars().allMatch(letter -> letter >= ' ' && letter <= '~');
        boolean fits = passphrase.length() >= SHORTEST
                && passphrase.length() <= LONGEST
                && passphrase.equals(passphrase.strip());
        if (!printable || !fits) {
            throw new InvalidInput(
                    ValueProblem.VALUE_MALFORMED, "passphrase", FORM, "\"passphrase\" must be " + FORM + ".");
        }
        return passphrase;
    }

    /** As ground stations make it. */
    private static LinkKey key(String passphrase) {
        try {
            return new LinkKey(
                    MessageDigest.getInstance("SHA-256").digest(passphrase.getBytes(StandardCharsets.US_ASCII)));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }
}
