package org.dronemap.ws.robotkey;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Max;
import jakarta.validation.constraints.Min;
import jakarta.validation.constraints.Size;
import java.time.Clock;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.function.Supplier;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.access.VisibilityLevel;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.link.RobotKey;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.history.NameRedaction;
import org.dronemap.ws.link.VehicleEndpointGateway;
import org.dronemap.ws.organisation.OrganisationService;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ServerProblem;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.NameRules;
import org.dronemap.ws.reading.SecretGenerator;
import org.jspecify.annotations.Nullable;

/**
 * Issues, lists and revokes keys of ROSLink robots, for administrators of the organisations that own them. Any thread.
 */
final class RobotKeyService {
    static final int LONGEST_LABEL = 60;
    static final int LAST_SYSTEM_ID = 65_535;
    private static final int MOST = 2_000;
    private static final String SYSTEM_ID = "systemId";
    private static final String SYSTEM_ID_FORM = "0 to " + LAST_SYSTEM_ID;

    private final RobotKeyRing ring;
    private final Dependencies around;
    private final SecretGenerator secrets;
    private final Clock clock;
    private final Supplier<DroneId> newIds;

    /** The links that end with a key, the drones that robots are, and whose they are. */
    record Dependencies(VehicleEndpointGateway links, CloudManager cloud, OrganisationService organisations) {}

    /**
     * A key for a robot that is still to come, or a new one for one that has one.
     *
     * @param systemId the only one that the robot may have
     * @param owner whom it has to name where it names an owner; without, anybody
     * @param organisation where it shall belong; without, the asker's
     * @param drone whose key is to be replaced; without, it becomes a new drone
     */
    @Schema(name = "RobotKeyRequest")
    record RobotKeyRequest(
            @Size(min = 1, max = RobotKeyService.LONGEST_LABEL) @Nullable
            String label,

            @Min(0) @Max(RobotKeyService.LAST_SYSTEM_ID) @Nullable
            Integer systemId,

            @Size(min = 1, max = RobotKeyService.LONGEST_LABEL) @Nullable
            String owner,

            @Nullable String organisation,
            @Nullable String drone) {}

    /**
     * A key as administrators see it.
     *
     * @param id of the drone that the robot is, from the first time that it calls in
     * @param key once, in the answer that made it
     */
    @Schema(name = "RobotKeyView")
    record RobotKeyView(
            String id,
            String label,
            int systemId,
            @Nullable String owner,
            String madeBy,
            Instant madeAt,
            boolean connected,
            @Nullable String key) {

        /** It may hold a secret. */
        @Override
        public String toString() {
            return "RobotKeyView[" + id + "]";
        }
    }

    RobotKeyService(
            RobotKeyRing ring, Dependencies around, SecretGenerator secrets, Clock clock, Supplier<DroneId> newIds) {
        this.ring = ring;
        this.around = around;
        this.secrets = secrets;
        this.clock = clock;
        this.newIds = newIds;
    }

    List<RobotKeyView> keys(Principal principal) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        return ring.keys().stream()
                .filter(key -> isShownTo(principal, key))
                .map(key -> view(principal, key, null))
                .toList();
    }

    RobotKeyView issue(Principal principal, RobotKeyRequest request) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        String drone = request.drone();
        RobotKey before = drone == null ? null : find(principal, drone);
        OrganisationId organisation = around.organisations().invitedInto(principal, request.organisation());
        String secret = RobotKeyRing.fresh(secrets);
        RobotKey key = new RobotKey(
                before == null ? newIds.get() : before.drone(),
                label(request, before),
                systemId(request, before),
                owner(request, before),
                SecretGenerator.hash(secret),
                principal.name(),
                principal.account(),
                clock.instant().truncatedTo(ChronoUnit.MILLIS));
        if (before == null) {
            if (ring.keys().size() >= MOST) {
                throw Rejection.of(
                        ServerProblem.LIMIT_REACHED,
                        MOST + " robots have keys already; revoke some first.",
                        ProblemParameter.WHAT.is("robot keys"),
                        ProblemParameter.MOST.is(MOST));
            }
            // Whose it is stands before anybody can come with it.
            around.organisations().enrolled(key.drone(), organisation);
        }
        ring.put(key);
        around.links().disconnect(key.drone().value());
        return view(principal, key, secret);
    }

    private static String label(RobotKeyRequest request, @Nullable RobotKey before) {
        String said = request.label();
        return said == null && before != null ? before.label() : NameRules.checked("label", said, LONGEST_LABEL);
    }

    private static int systemId(RobotKeyRequest request, @Nullable RobotKey before) {
        Integer said = request.systemId();
        if (said == null && before != null) {
            return before.systemId();
        }
        if (said == null) {
            throw new InvalidInput(
                    ValueProblem.VALUE_MISSING,
                    SYSTEM_ID,
                    SYSTEM_ID_FORM,
                    "\"systemId\" is missing: " + SYSTEM_ID_FORM + ".");
        }
        if (said < 0 || said > LAST_SYSTEM_ID) {
            throw InvalidInput.outside(
                    ValueProblem.VALUE_OUT_OF_RANGE,
                    SYSTEM_ID,
                    SYSTEM_ID_FORM,
                    said,
                    ProblemParameter.LEAST.is(0),
                    ProblemParameter.MOST.is(LAST_SYSTEM_ID));
        }
        return said;
    }

    private static @Nullable String owner(RobotKeyRequest request, @Nullable RobotKey before) {
        String said = request.owner();
        if (said == null) {
            return before == null ? null : before.owner();
        }
        return NameRules.checked("owner", said, LONGEST_LABEL);
    }

    /** The robot's links end at once, and whoever shows the key from then on is turned away. */
    void revoke(Principal principal, String id) {
        RoleChecks.requireForAll(principal, Role.ADMINISTRATOR);
        DroneId drone = find(principal, id).drone();
        if (!ring.remove(drone)) {
            throw Rejection.unknown(NotFoundProblem.ROBOT_KEY, id);
        }
        around.links().disconnect(drone.value());
    }

    private RobotKey find(Principal principal, String id) {
        return ring.keys().stream()
                .filter(key -> key.drone().value().equals(id) && isShownTo(principal, key))
                .findFirst()
                .orElseThrow(() -> Rejection.unknown(NotFoundProblem.ROBOT_KEY, id));
    }

    /** Those of one's own organisation, and those that one issued oneself for another one. */
    private boolean isShownTo(Principal principal, RobotKey key) {
        return principal.sees(key.drone())
                || (key.account().equals(principal.account())
                        && !around.organisations().wasGiven(key.drone(), key.madeAt()));
    }

    private RobotKeyView view(Principal principal, RobotKey key, @Nullable String secret) {
        boolean connected = around.cloud()
                .drone(key.drone())
                .filter(drone -> drone.link().state() != LinkState.LOST)
                .isPresent();
        return new RobotKeyView(
                key.drone().value(),
                key.label(),
                key.systemId(),
                key.owner(),
                principal.sight(key.drone(), key.madeAt()) == VisibilityLevel.ALL
                                || key.account().equals(principal.account())
                        ? key.madeBy()
                        : NameRedaction.OTHERS,
                key.madeAt(),
                connected,
                secret);
    }
}
