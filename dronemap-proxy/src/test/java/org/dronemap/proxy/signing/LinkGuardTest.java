package org.dronemap.proxy.signing;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.access.LinkKey;
import org.dronemap.core.access.LinkSecurity;
import org.dronemap.core.access.LinkSecurityStore;
import org.dronemap.core.access.LinkSigningPolicy;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.time.SteppedTime;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.SetupSigning;
import org.dronemap.mavlink.message.Timesync;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class LinkGuardTest {
    private static final DroneId DRONE = new DroneId("d7k2m9q4xa");
    private static final DroneId OTHER = new DroneId("q4xad7k2m9");
    private static final LinkKey KEY = SigningVehicle.key(1);
    private static final LinkKey FOREIGN = SigningVehicle.key(200);
    private static final Heartbeat BEAT = new Heartbeat(6, 8, 0, 0, 4, 3);
    private static final Timesync NO_BEAT = new Timesync(0, 1, 0, 0);

    private final SteppedTime time = new SteppedTime(Instant.parse("2026-03-01T12:00:00Z"));
    private long now = 1_000_000_000_000L;
    private final StoreWriter journal = new StoreWriter(time);
    private final Kept kept = new Kept();
    private final SigningVehicle vehicle = new SigningVehicle(time.clock());

    @AfterEach
    void close() {
        journal.close();
    }

    private LinkGuard guard(LinkSigningPolicy policy) {
        kept.all.add(new LinkSecurity(DRONE, policy, KEY, null, true, 0));
        KeyringRegistry.Dependencies keeping = new KeyringRegistry.Dependencies(
                kept, journal, drone -> SigningVehicle.SYSTEM_ID, (drone, sentence) -> {});
        return new KeyringRegistry(keeping, time).guard(0, () -> true);
    }

    @Test
    void aValidSignatureProvesWhoItIsBeforeAnybodyAsked() {
        LinkGuard guard = guard(LinkSigningPolicy.REQUIRED);
        assertThat(guard.signer()).isEmpty();

        assertThat(guard.judge(vehicle.signed(KEY), now)).isEqualTo(FrameAdmission.PROVEN);
        assertThat(guard.signer()).contains(DRONE);
        assertThat(guard.mayBind(Optional.empty())).isTrue();
    }

    @Test
    void aRecordedFrameProvesNothing() {
        LinkGuard guard = guard(LinkSigningPolicy.REQUIRED);
        Frame old = vehicle.signed(KEY);
        time.advance(Duration.ofHours(1));

        assertThat(guard.judge(old, now)).isEqualTo(FrameAdmission.REFUSED);
        assertThat(guard.signer()).isEmpty();
        assertThat(guard.mayBind(Optional.empty())).isFalse();
    }

    @Test
    void whoOnlyLooksLikeADroneThatMustSignIsNotBoundToIt() {
        LinkGuard guard = guard(LinkSigningPolicy.REQUIRED);
        assertThat(guard.judge(vehicle.unsigned(), now)).isEqualTo(FrameAdmission.ADMITTED);

        assertThat(guard.mayBind(Optional.of(DRONE))).isFalse();
        assertThat(guard.judge(vehicle.unsigned(), now)).isEqualTo(FrameAdmission.REFUSED);
        assertThat(guard.judge(vehicle.signed(FOREIGN), now)).isEqualTo(FrameAdmission.REFUSED);
        assertThat(guard.judge(vehicle.signed(KEY), now)).isEqualTo(FrameAdmission.PROVEN);
        assertThat(guard.mayBind(Optional.of(DRONE))).isTrue();
    }

    @Test
    void whoNeedNotSignIsBoundAsBefore() {
        LinkGuard guard = guard(LinkSigningPolicy.OPTIONAL);
        guard.judge(vehicle.unsigned(), now);
        assertThat(guard.mayBind(Optional.of(DRONE))).isTrue();
        assertThat(guard.mayBind(Optional.of(OTHER))).isTrue();
        assertThat(guard.signer()).isEmpty();
    }

    @Test
    void whoBringsOnlyCopiesOfSignedMessagesIsNoStranger() {
        LinkGuard guard = guard(LinkSigningPolicy.OPTIONAL);
        Frame old = vehicle.signed(KEY);
        time.advance(Duration.ofHours(1));

        assertThat(guard.judge(old, now)).isEqualTo(FrameAdmission.REFUSED);
        assertThat(guard.mayBind(Optional.empty())).isFalse();
        assertThat(guard.judge(vehicle.signed(KEY), now)).isEqualTo(FrameAdmission.PROVEN);
        assertThat(guard.mayBind(Optional.empty())).isTrue();
    }

    @Test
    void onlyHeartbeatsAreSignedForWhoHasNotProvenItself() {
        LinkGuard guard = guard(LinkSigningPolicy.REQUIRED);
        assertThat(guard.signer(BEAT)).isNull();
        Frame old = vehicle.signed(KEY);
        time.advance(Duration.ofHours(1));
        guard.judge(old, now);

        assertThat(guard.signer(BEAT)).isNotNull();
        assertThat(guard.signer(NO_BEAT)).isNull();
        guard.judge(vehicle.signed(KEY), now);
        assertThat(guard.signer(NO_BEAT)).isNotNull();
    }

    @Test
    void theKeyOfAnotherDroneUndoesTheBinding() {
        LinkGuard guard = guard(LinkSigningPolicy.REQUIRED);
        guard.bound(OTHER, SigningVehicle.SYSTEM_ID);
        assertThat(guard.contradicts()).isFalse();
        guard.judge(vehicle.signed(KEY), now);
        assertThat(guard.contradicts()).isTrue();
        guard.unbound();

        assertThat(guard.judge(vehicle.signed(KEY), now)).isEqualTo(FrameAdmission.PROVEN);
        assertThat(guard.signer()).contains(DRONE);
    }

    @Test
    void aKeySentToUsIsNobodysBusiness() {
        LinkGuard guard = guard(LinkSigningPolicy.OFF);
        assertThat(guard.judge(vehicle.unsigned(new SetupSigning(255, 190, new int[32], 5)), now))
                .isEqualTo(FrameAdmission.REFUSED);
    }

    private static final class Kept implements LinkSecurityStore {
        private final List<LinkSecurity> all = new ArrayList<>();

        @Override
        public List<LinkSecurity> all() {
            return all;
        }

        @Override
        public void save(LinkSecurity security) {
            all.add(security);
        }

        @Override
        public void saveStamp(DroneId drone, long stamp) {}
    }
}
