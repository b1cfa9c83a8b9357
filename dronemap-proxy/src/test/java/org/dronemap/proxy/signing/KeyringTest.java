package org.dronemap.proxy.signing;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import org.dronemap.core.access.LinkKey;
import org.dronemap.core.access.LinkSecurity;
import org.dronemap.core.access.LinkSigningPolicy;
import org.dronemap.core.drone.DroneId;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.RadioStatus;
import org.dronemap.mavlink.signing.SigningClock;
import org.junit.jupiter.api.Test;

class KeyringTest {
    private static final DroneId DRONE = new DroneId("d7k2m9q4xa");
    private static final LinkKey KEY = SigningVehicle.key(1);
    private static final LinkKey NEXT = SigningVehicle.key(100);
    private static final LinkKey FOREIGN = SigningVehicle.key(200);
    private static final long SECOND = 1_000_000_000L;

    private Instant wall = Instant.parse("2026-03-01T12:00:00Z");
    private long now = 1_000 * SECOND;
    private final List<String> warnings = new ArrayList<>();
    private final List<LinkSecurity> kept = new ArrayList<>();
    private final List<Long> stamps = new ArrayList<>();
    private final SigningVehicle vehicle = new SigningVehicle(() -> wall);
    private final Set<LinkGuard> links = new HashSet<>();
    private final LinkGuard safe = new LinkGuard(null, 0, () -> true);
    private final LinkGuard open = new LinkGuard(null, 0, () -> false);

    private Keyring ring(LinkSigningPolicy policy, boolean proven) {
        return ring(new LinkSecurity(DRONE, policy, KEY, null, proven, 0));
    }

    private Keyring ring(LinkSecurity security) {
        return new Keyring(
                security,
                SigningVehicle.SYSTEM_ID,
                () -> wall,
                new Keyring.Callbacks(
                        (now, after) -> {
                            kept.add(now);
                            after.run();
                        },
                        now -> stamps.add(now.stamp()),
                        warnings::add),
                links);
    }

    private void pass(double seconds) {
        now += (long) (seconds * SECOND);
        wall = wall.plusNanos((long) (seconds * SECOND));
    }

    private FrameAdmission hear(Keyring ring, Frame frame) {
        return ring.admit(frame, now);
    }

    @Test
    void aRequiredDroneIsSpokenForByItsKeyOnly() {
        Keyring ring = ring(LinkSigningPolicy.REQUIRED, true);
        Frame good = vehicle.signed(KEY);

        assertThat(hear(ring, good)).isEqualTo(FrameAdmission.PROVEN);
        assertThat(hear(ring, good)).isEqualTo(FrameAdmission.REFUSED);
        assertThat(hear(ring, vehicle.unsigned())).isEqualTo(FrameAdmission.REFUSED);
        assertThat(hear(ring, vehicle.signed(FOREIGN))).isEqualTo(FrameAdmission.REFUSED);
        Frame late = vehicle.signed(KEY, 9);
        pass(61);
        assertThat(hear(ring, late)).isEqualTo(FrameAdmission.REFUSED);
        assertThat(ring.status().counts()).isEqualTo(new SignatureCounts(1, 1, 1, 1, 1, 0));
    }

    @Test
    void eachKindOfRefusalIsToldOnceUntilItWasQuietForTenMinutes() {
        Keyring ring = ring(LinkSigningPolicy.REQUIRED, true);
        for (int i = 0; i < 50; i++) {
            hear(ring, vehicle.unsigned());
            pass(1);
        }
        assertThat(warnings)
                .containsExactly("Unsigned messages came in this drone's name; they are refused and counted.");

        pass(601);
        hear(ring, vehicle.unsigned());
        hear(ring, vehicle.signed(FOREIGN));
        assertThat(warnings).hasSize(3);
    }

    @Test
    void aRadiosReportPassesUnsignedButProvesNothing() {
        Keyring ring = ring(LinkSigningPolicy.REQUIRED, true);
        Frame report = vehicle.unsigned(new RadioStatus(100, 100, 80, 10, 10, 0, 0));

        assertThat(hear(ring, report)).isEqualTo(FrameAdmission.ASIDE);
        assertThat(ring.status().counts().refused()).isZero();
    }

    @Test
    void anOptionalDroneMaySpeakUnsignedButNotSignWrongly() {
        Keyring ring = ring(LinkSigningPolicy.OPTIONAL, true);

        assertThat(hear(ring, vehicle.unsigned())).isEqualTo(FrameAdmission.ADMITTED);
        assertThat(hear(ring, vehicle.signed(FOREIGN))).isEqualTo(FrameAdmission.REFUSED);
        assertThat(hear(ring, vehicle.signed(KEY))).isEqualTo(FrameAdmission.PROVEN);
    }

    @Test
    void aKeyThatWasOnlyMadeLocksNobodyOut() {
        Keyring ring = ring(LinkSigningPolicy.OPTIONAL, false);

        assertThat(hear(ring, vehicle.signed(FOREIGN))).isEqualTo(FrameAdmission.ADMITTED);
        assertThat(ring.security().proven()).isFalse();
        assertThat(hear(ring, vehicle.signed(KEY))).isEqualTo(FrameAdmission.PROVEN);
        assertThat(kept).last().extracting(LinkSecurity::proven).isEqualTo(true);
    }

    @Test
    void aRotationHoldsWhatGoesOutAndLosesNothingThatComesIn() {
        Keyring ring = ring(LinkSigningPolicy.REQUIRED, true);
        CompletableFuture<KeyChangeResult> end = ring.begin(KeyChangeKind.ROTATE, NEXT, false);

        Keyring.Request request = ring.advance(safe, now);
        assertThat(request).isNotNull();
        assertThat(request.key()).isEqualTo(NEXT);
        assertThat(ring.holds(now)).isTrue();
        assertThat(hear(ring, vehicle.signed(KEY))).isEqualTo(FrameAdmission.PROVEN);
        Frame inFlight = vehicle.signed(KEY);
        pass(0.2);
        assertThat(end).isNotDone();

        assertThat(hear(ring, vehicle.signed(NEXT))).isEqualTo(FrameAdmission.PROVEN);
        assertThat(end).isCompletedWithValue(new KeyChangeResult.Done());
        assertThat(ring.holds(now)).isFalse();
        assertThat(hear(ring, inFlight)).isEqualTo(FrameAdmission.PROVEN);
        assertThat(kept).last().satisfies(security -> {
            assertThat(security.key()).isEqualTo(NEXT);
            assertThat(security.nextKey()).isNull();
        });

        pass(31);
        assertThat(hear(ring, vehicle.signed(KEY))).isEqualTo(FrameAdmission.REFUSED);
    }

    @Test
    void theOldKeyStaysWhenTheVehicleGoesOnWithIt() {
        Keyring ring = ring(LinkSigningPolicy.REQUIRED, true);
        CompletableFuture<KeyChangeResult> end = ring.begin(KeyChangeKind.ROTATE, NEXT, false);
        int asked = 0;
        for (int i = 0; i < 200 && !end.isDone(); i++) {
            asked += ring.advance(safe, now) == null ? 0 : 1;
            hear(ring, vehicle.signed(KEY));
            pass(0.1);
        }

        assertThat(asked).isEqualTo(5);
        assertThat(end.join()).isInstanceOf(KeyChangeResult.Failed.class);
        assertThat(ring.security().key()).isEqualTo(KEY);
        assertThat(ring.security().nextKey()).isNull();
        assertThat(hear(ring, vehicle.signed(KEY))).isEqualTo(FrameAdmission.PROVEN);
        assertThat(hear(ring, vehicle.signed(NEXT))).isEqualTo(FrameAdmission.REFUSED);
    }

    @Test
    void whenTheVehicleFallsSilentBothKeysStayUntilItIsHeard() {
        Keyring ring = ring(LinkSigningPolicy.REQUIRED, true);
        CompletableFuture<KeyChangeResult> end = ring.begin(KeyChangeKind.ROTATE, NEXT, false);
        for (int i = 0; i < 200 && !end.isDone(); i++) {
            ring.advance(safe, now);
            pass(0.1);
        }
        assertThat(end.join()).isInstanceOf(KeyChangeResult.Unknown.class);

        Keyring restarted = ring(kept.get(kept.size() - 1));
        assertThat(hear(restarted, vehicle.signed(NEXT))).isEqualTo(FrameAdmission.PROVEN);
        assertThat(restarted.security().key()).isEqualTo(NEXT);
        assertThat(restarted.security().nextKey()).isNull();
    }

    @Test
    void theVehiclesOwnRefusalEndsTheRotationAtOnce() {
        Keyring ring = ring(LinkSigningPolicy.REQUIRED, true);
        CompletableFuture<KeyChangeResult> end = ring.begin(KeyChangeKind.ROTATE, NEXT, false);
        ring.advance(safe, now);
        ring.textReceived("EKF3 IMU0 is using GPS");
        assertThat(end).isNotDone();
        ring.textReceived("ERROR: Won't setup signing when armed");

        assertThat(end.join())
                .isEqualTo(new KeyChangeResult.Failed(
                        KeyChangeFault.REFUSED, "The vehicle says: ERROR: Won't setup signing when armed"));
        assertThat(ring.holds(now)).isFalse();
        assertThat(ring.security().key()).isEqualTo(KEY);
    }

    @Test
    void aKeyGoesOverNoLinkThatOthersMayHear() {
        Keyring ring = ring(LinkSigningPolicy.REQUIRED, true);
        assertThat(ring.obstacle(KeyChangeKind.ROTATE, true))
                .isEqualTo(new KeyChangeResult.Failed(KeyChangeFault.NO_LINK, "The drone has no link now."));
        links.add(open);
        assertThat(ring.obstacle(KeyChangeKind.ROTATE, false))
                .extracting(KeyChangeResult.Failed::fault)
                .isEqualTo(KeyChangeFault.LINK_NOT_SAFE);
        assertThat(ring.obstacle(KeyChangeKind.ROTATE, true)).isNull();
        links.add(safe);
        assertThat(ring.obstacle(KeyChangeKind.ROTATE, false)).isNull();

        ring.begin(KeyChangeKind.ROTATE, NEXT, false);
        assertThat(ring.advance(open, now)).isNull();
        assertThat(ring.advance(safe, now)).isNotNull();
    }

    @Test
    void installingEndsWhenTheVehicleIsHeardToSign() {
        Keyring ring = ring(LinkSigningPolicy.OPTIONAL, false);
        CompletableFuture<KeyChangeResult> end = ring.begin(KeyChangeKind.INSTALL, null, false);
        assertThat(ring.advance(safe, now)).extracting(Keyring.Request::key).isEqualTo(KEY);
        assertThat(ring.holds(now)).isFalse();
        hear(ring, vehicle.unsigned());
        assertThat(end).isNotDone();
        hear(ring, vehicle.signed(KEY));

        assertThat(end).isCompletedWithValue(new KeyChangeResult.Done());
        assertThat(ring.security().proven()).isTrue();
    }

    @Test
    void revokingEndsWhenTheVehicleIsHeardUnsigned() {
        Keyring ring = ring(LinkSigningPolicy.REQUIRED, true);
        CompletableFuture<KeyChangeResult> end = ring.begin(KeyChangeKind.REVOKE, null, false);
        assertThat(ring.advance(open, now)).extracting(Keyring.Request::key).isNull();
        hear(ring, vehicle.signed(KEY));
        assertThat(end).isNotDone();

        assertThat(hear(ring, vehicle.unsigned())).isEqualTo(FrameAdmission.ADMITTED);
        assertThat(end).isCompletedWithValue(new KeyChangeResult.Done());
        assertThat(ring.security())
                .isEqualTo(new LinkSecurity(
                        DRONE,
                        LinkSigningPolicy.OFF,
                        null,
                        null,
                        false,
                        ring.security().stamp()));
        assertThat(ring.signer(0)).isNull();
    }

    @Test
    void theTimeOfSignaturesIsStoredEveryMinuteAndNeverGoesBack() {
        Keyring ring = ring(LinkSigningPolicy.REQUIRED, true);
        for (int second = 0; second < 300; second++) {
            ring.advance(safe, now);
            pass(1);
        }
        assertThat(stamps).hasSizeBetween(5, 7).isSorted();

        wall = wall.minusSeconds(7_200);
        long last = stamps.get(stamps.size() - 1);
        Keyring behind = ring(new LinkSecurity(DRONE, LinkSigningPolicy.REQUIRED, KEY, null, true, last));
        assertThat(behind.security().stamp()).isGreaterThanOrEqualTo(last + 60 * SigningClock.TICKS_PER_SECOND);
    }

    @Test
    void nothingTellsASecret() {
        String secret = java.util.HexFormat.of().formatHex(KEY.secret());
        Keyring ring = ring(LinkSigningPolicy.REQUIRED, true);

        assertThat(ring.security().toString() + ring.status() + ring.advance(safe, now) + KEY)
                .doesNotContainIgnoringCase(secret.substring(0, 8));
    }
}
