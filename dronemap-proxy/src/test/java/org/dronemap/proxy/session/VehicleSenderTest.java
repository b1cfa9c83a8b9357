package org.dronemap.proxy.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.LongStream;
import org.dronemap.core.access.LinkKey;
import org.dronemap.core.access.LinkSecurity;
import org.dronemap.core.access.LinkSigningPolicy;
import org.dronemap.core.cloud.EpochGuard;
import org.dronemap.core.cloud.SendAuthority;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.time.RealTime;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.Attitude;
import org.dronemap.mavlink.message.SetupSigning;
import org.dronemap.proxy.TestKeyrings;
import org.dronemap.proxy.signing.KeyChangeKind;
import org.dronemap.proxy.signing.KeyringRegistry;
import org.dronemap.proxy.signing.LinkGuard;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class VehicleSenderTest {
    private static final DroneId DRONE = new DroneId("d7k2m9q4xa");
    private static final long SECOND = 1_000_000_000L;

    private final StoreWriter journal = new StoreWriter(new RealTime());
    private final CapturingPeer hop = new CapturingPeer("udp", 14_550);
    private final VehicleSender downlink = new VehicleSender(hop);
    private long now = 1_000 * SECOND;

    @BeforeEach
    void changeTheKey() {
        TestKeyrings kept = new TestKeyrings();
        kept.save(new LinkSecurity(DRONE, LinkSigningPolicy.REQUIRED, key(1), null, true, 0));
        KeyringRegistry keyrings = new KeyringRegistry(
                new KeyringRegistry.Dependencies(kept, journal, drone -> 1, (drone, sentence) -> {}), new RealTime());
        LinkGuard guard = keyrings.guard(0, () -> true);
        guard.bound(DRONE, 1);
        downlink.guardedBy(guard);
        assertThat(keyrings.change(DRONE, KeyChangeKind.ROTATE, key(2), false)).isNotDone();
        assertThat(guard.advance(1, 1, now)).isNotNull();
    }

    @AfterEach
    void close() {
        journal.close();
    }

    private static LinkKey key(int first) {
        byte[] secret = new byte[LinkKey.BYTES];
        secret[0] = (byte) first;
        return new LinkKey(secret);
    }

    private void send(int from, int to) {
        for (int i = from; i < to; i++) {
            downlink.send(new Attitude(i, 0f, 0f, 0f, 0f, 0f, 0f), SendAuthority.HOUSEKEEPING, now);
        }
    }

    private List<Long> numbers() {
        return hop.heard().stream()
                .filter(frame -> frame.messageId() == Attitude.ID)
                .map(frame -> Attitude.decode(frame).timeBootMs())
                .toList();
    }

    @Test
    void keepsWhatMustWaitForAKeyInItsOrder() {
        send(1, 6);
        assertThat(hop.heard()).isEmpty();

        now += 2 * SECOND;
        send(6, 7);
        assertThat(numbers()).containsExactly(1L, 2L, 3L, 4L, 5L, 6L);
        assertThat(hop.heard()).allMatch(Frame::signed);
    }

    @Test
    void letsTheOldestFallOutOfWhatWaits() {
        send(0, 300);
        downlink.releaseDue(now);
        assertThat(hop.heard()).isEmpty();

        downlink.releaseDue(now + 2 * SECOND);
        assertThat(numbers())
                .containsExactlyElementsOf(
                        LongStream.range(300 - 256, 300).boxed().toList());
    }

    @Test
    void letsNothingGoThatMayNotGoAnyMoreWhenItsTurnComes() {
        AtomicBoolean open = new AtomicBoolean(true);
        EpochGuard fence = send -> {
            if (open.get()) {
                send.run();
            }
            return open.get();
        };
        downlink.send(new Attitude(1, 0f, 0f, 0f, 0f, 0f, 0f), new SendAuthority(null, null, "ann", fence), now);
        send(2, 3);
        open.set(false);

        downlink.releaseDue(now + 2 * SECOND);
        assertThat(numbers()).containsExactly(2L);
    }

    @Test
    void aKeyWaitsForNothing() {
        send(1, 6);
        downlink.sendSecret(new SetupSigning(1, 1, new int[LinkKey.BYTES], 1));
        assertThat(hop.heard()).extracting(Frame::messageId).containsExactly(SetupSigning.ID);
    }
}
