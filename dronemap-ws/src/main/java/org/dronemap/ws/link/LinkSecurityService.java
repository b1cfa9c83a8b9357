package org.dronemap.ws.link;

import io.swagger.v3.oas.annotations.media.Schema;
import java.security.SecureRandom;
import java.time.Duration;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeoutException;
import org.dronemap.core.access.LinkKey;
import org.dronemap.core.access.LinkSigningPolicy;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.time.Time;
import org.dronemap.ws.drone.DroneService;
import org.dronemap.ws.problem.CommandProblem;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.LinkSecurityProblem;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.ValueProblem;
import org.dronemap.ws.reading.EnumValues;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Sets the signing policy and the signing keys of a drone's MAVLink links. For administrators; everybody may look. Any
 * thread.
 */
public final class LinkSecurityService {
    private static final Logger LOG = LoggerFactory.getLogger(LinkSecurityService.class);
    private static final String POLICIES = "off, optional or required";
    private static final String KEY_FORM = "64 hexadecimal digits, not all zero";
    private static final Duration LONGEST_CHANGE = Duration.ofSeconds(25);

    private final LinkSecurityGateway links;
    private final DroneService drones;
    private final Time time;
    private final SecureRandom random = new SecureRandom();

    /** A change of the policy. */
    @Schema(name = "LinkSecurityPolicyRequest")
    public record PolicyRequest(
            @EnumValues(LinkSigningPolicy.class) @Nullable String policy) {}

    /** A new key; without one given it is made up. */
    @Schema(name = "LinkKeyRequest")
    public record LinkKeyRequest(@Nullable String key) {

        /** It may hold a secret. */
        @Override
        public String toString() {
            return "LinkKeyRequest[]";
        }
    }

    /** {@code confirm}: the asker vouches that nobody listens on the link. */
    @Schema(name = "LinkSecurityChangeRequest")
    public record ChangeRequest(@Nullable Boolean confirm) {}

    /** A key that was just made; this is the only time that it is shown. */
    @Schema(name = "MadeLinkKey")
    public record MadeKey(String fingerprint, String key) {

        @Override
        public String toString() {
            return "MadeKey[" + fingerprint + "]";
        }
    }

    public LinkSecurityService(LinkSecurityGateway links, DroneService drones, Time time) {
        this.links = links;
        this.drones = drones;
        this.time = time;
    }

    public LinkSecurityView look(Principal principal, String id) {
        return links.view(drones.state(principal, id).id());
    }

    public LinkSecurityView setPolicy(Principal principal, String id, PolicyRequest request) {
        DroneId drone = securable(principal, id);
        String wanted = request.policy();
        if (wanted == null) {
            throw InvalidInput.missing("policy", POLICIES);
        }
        LinkSigningPolicy policy = Arrays.stream(LinkSigningPolicy.values())
                .filter(each -> WireNames.camel(each).equals(wanted))
                .findFirst()
                .orElseThrow(() ->
                        InvalidInput.outside(ValueProblem.VALUE_NOT_ALLOWED, "policy", POLICIES, "\"" + wanted + "\""));
        refuse(drone, links.policy(drone, policy));
        LOG.info("{} set the link policy of {} to {}", principal.name(), drone, wanted);
        return links.view(drone);
    }

    /** A key for a vehicle that uses none yet. */
    public MadeKey makeKey(Principal principal, String id, LinkKeyRequest request) {
        DroneId drone = securable(principal, id);
        LinkKey key = request.key() == null ? newKey() : given(request.key());
        if (!links.put(drone, key)) {
            throw Rejection.of(
                    LinkSecurityProblem.KEY_IN_USE,
                    "The vehicle uses a key already; rotate it, or revoke it first.",
                    ProblemParameter.DRONE.is(drone.value()));
        }
        LOG.info("{} made the link key {} for {}", principal.name(), key.fingerprint(), drone);
        return new MadeKey(key.fingerprint(), HexFormat.of().formatHex(key.secret()));
    }

    /** Waits until the vehicle was heard to use the key, or not; longer changes go on and show in the answer. */
    public LinkSecurityView install(Principal principal, String id, @Nullable ChangeRequest request) {
        return change(principal, id, LinkSecurityGateway.Change.INSTALL, request);
    }

    /** The vehicle changes over to a new key, which is never shown. */
    public LinkSecurityView rotate(Principal principal, String id, @Nullable ChangeRequest request) {
        return change(principal, id, LinkSecurityGateway.Change.ROTATE, request);
    }

    /** Takes the key off the vehicle, or with {@code vehicle} false forgets it here only. */
    public LinkSecurityView revoke(Principal principal, String id, boolean vehicle) {
        if (vehicle) {
            return change(principal, id, LinkSecurityGateway.Change.REVOKE, null);
        }
        DroneId drone = securable(principal, id);
        links.forget(drone);
        LOG.info("{} forgot the link key of {}", principal.name(), drone);
        return links.view(drone);
    }

    private LinkSecurityView change(
            Principal principal, String id, LinkSecurityGateway.Change change, @Nullable ChangeRequest request) {
        DroneId drone = securable(principal, id);
        boolean confirmed = request != null && Boolean.TRUE.equals(request.confirm());
        LinkKey next = change == LinkSecurityGateway.Change.ROTATE ? newKey() : null;
        LOG.info(
                "{} asks to {} the link key of {}{}",
                principal.name(),
                WireNames.camel(change),
                drone,
                confirmed ? ", vouching for the link" : "");
        await(links.change(drone, change, next, confirmed)).ifPresent(why -> refuse(drone, Optional.of(why)));
        return links.view(drone);
    }

    private Optional<LinkSecurityGateway.Fault> await(CompletableFuture<Optional<LinkSecurityGateway.Fault>> end) {
        try {
            return time.await(end, LONGEST_CHANGE);
        } catch (TimeoutException stillUnderWay) {
            return Optional.empty();
        } catch (ExecutionException e) {
            throw new IllegalStateException("the change of a link key failed", e.getCause());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted while a link key was changed", e);
        }
    }

    private static void refuse(DroneId drone, Optional<LinkSecurityGateway.Fault> why) {
        if (why.isPresent()) {
            throw Rejection.of(why.get().code(), why.get().sentence(), ProblemParameter.DRONE.is(drone.value()));
        }
    }

    private DroneId securable(Principal principal, String id) {
        DroneState state = drones.state(principal, id, Role.ADMINISTRATOR);
        if (state.replay()) {
            throw Rejection.of(
                    new CommandProblem(OutcomeCode.DRONE_IS_A_RECORDING),
                    "This drone comes from a recording; it has no link to secure.",
                    ProblemParameter.DRONE.is(state.id().value()));
        }
        return state.id();
    }

    private LinkKey newKey() {
        byte[] secret = new byte[LinkKey.BYTES];
        random.nextBytes(secret);
        return new LinkKey(secret);
    }

    private static LinkKey given(String text) {
        if (text.matches("[0-9a-fA-F]{64}") && !text.matches("0{64}")) {
            return new LinkKey(HexFormat.of().parseHex(text));
        }
        throw new InvalidInput(ValueProblem.VALUE_MALFORMED, "key", KEY_FORM, "\"key\" must be " + KEY_FORM + ".");
    }
}
