package org.dronemap.ws.link;

import io.swagger.v3.oas.annotations.media.Schema;
import jakarta.validation.constraints.Size;
import java.security.SecureRandom;
import java.time.Clock;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Set;
import java.util.UUID;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.link.DtlsKey;
import org.dronemap.ws.access.RoleChecks;
import org.dronemap.ws.problem.NotFoundProblem;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.reading.NameRules;
import org.jspecify.annotations.Nullable;

/**
 * Creates, lists and revokes the DTLS keys with which vehicles connect to encrypted endpoints, for administrators. Any
 * thread.
 */
public final class DtlsKeyService {
    private static final int LONGEST_LABEL = 60;
    private static final int SECRET_BYTES = 32;

    private final DtlsKeyRing ring;
    private final VehicleEndpointGateway links;
    private final CloudManager cloud;
    private final Clock clock;
    private final SecureRandom random = new SecureRandom();

    /** A new key: for a drone that is known, whose key before is revoked, or for a vehicle still to come. */
    @Schema(name = "DtlsKeyRequest")
    public record DtlsKeyRequest(
            @Size(min = 1, max = LONGEST_LABEL) @Nullable String label,
            @Nullable String drone) {}

    /**
     * A key as administrators see it.
     *
     * @param identity what the vehicle has to call itself
     * @param secret 32 bytes in hexadecimal, once, in the answer that made it
     */
    @Schema(name = "DtlsKeyView")
    public record DtlsKeyView(
            String identity,
            String label,
            String madeBy,
            Instant madeAt,
            boolean connected,
            @Nullable String secret) {}

    public DtlsKeyService(DtlsKeyRing ring, VehicleEndpointGateway links, CloudManager cloud, Clock clock) {
        this.ring = ring;
        this.links = links;
        this.cloud = cloud;
        this.clock = clock;
    }

    public List<DtlsKeyView> keys(Principal principal) {
        RoleChecks.requireServer(principal, Role.ADMINISTRATOR);
        Set<String> connected = links.all().stream()
                .flatMap(status -> status.peers().stream())
                .flatMap(peer -> Stream.ofNullable(peer.identity()))
                .collect(Collectors.toSet());
        return ring.keys().stream()
                .map(key -> view(key, connected.contains(key.identity()), null))
                .toList();
    }

    public DtlsKeyView make(Principal principal, DtlsKeyRequest request) {
        RoleChecks.requireServer(principal, Role.ADMINISTRATOR);
        String drone = request.drone();
        DroneState known = drone == null ? null : known(principal, drone);
        String identity = known == null ? fresh() : known.id().value();
        String label = NameRules.checked(
                "label", request.label() == null && known != null ? known.name() : request.label(), LONGEST_LABEL);
        byte[] secret = new byte[SECRET_BYTES];
        random.nextBytes(secret);
        DtlsKey key = new DtlsKey(identity, label, "", principal.name(), clock.instant());
        ring.put(key, secret);
        // What was proven with an older key is not proven any more.
        links.disconnect(identity);
        DtlsKeyView view = view(key, false, HexFormat.of().formatHex(secret));
        Arrays.fill(secret, (byte) 0);
        return view;
    }

    private DroneState known(Principal principal, String drone) {
        try {
            return cloud.drone(new DroneId(drone))
                    .filter(state -> principal.sees(state.id()))
                    .orElseThrow(() -> Rejection.unknown(NotFoundProblem.DRONE, drone));
        } catch (IllegalArgumentException noDronesId) {
            throw Rejection.unknown(NotFoundProblem.DRONE, drone);
        }
    }

    private static String fresh() {
        return "v" + UUID.randomUUID().toString().replace("-", "").substring(0, 16);
    }

    /** The vehicle's links end at once. */
    public void revoke(Principal principal, String identity) {
        RoleChecks.requireServer(principal, Role.ADMINISTRATOR);
        if (!ring.remove(identity)) {
            throw Rejection.unknown(NotFoundProblem.DTLS_KEY, identity);
        }
        links.disconnect(identity);
    }

    private static DtlsKeyView view(DtlsKey key, boolean connected, @Nullable String secret) {
        return new DtlsKeyView(
                key.identity(),
                key.label(),
                key.madeBy(),
                key.madeAt().truncatedTo(ChronoUnit.MILLIS),
                connected,
                secret);
    }
}
