package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.Arrays;
import java.util.HexFormat;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.mavlink.message.Attitude;
import org.dronemap.mavlink.signing.SigningClock;
import org.dronemap.ws.command.CommandRequest;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.LinkKeys;
import org.dronemap.ws.lab.PeerSigning;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.SigningPeer;
import org.dronemap.ws.lab.VehicleSpec;
import org.dronemap.ws.link.LinkSecurityView;
import org.dronemap.ws.link.LinkSecurityView.Messages;
import org.dronemap.ws.problem.Rejection;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Signed links: what moves a drone that must sign, and keys that are made, changed and taken away. */
class SignedLinkTest {
    private static final long SECOND = SigningClock.TICKS_PER_SECOND;
    private static final Duration SOON = Duration.ofSeconds(2);
    private static final CommandRequest ARM = CommandRequests.arm();

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ada = lab.pilot("ada", Role.ADMINISTRATOR);
    private final SigningPeer peer = lab.signingPeer(7).begin();
    private final DroneId drone = peer.listed();
    private final LinkKeys keys = new LinkKeys(lab, ada, drone);

    @AfterEach
    void close() {
        lab.close();
    }

    /** The vehicle signs and must; its key. */
    private byte[] secured() {
        byte[] key = keys.install();
        keys.policy("required");
        assertThat(peer.signing().keys()).containsExactly(HexFormat.of().formatHex(key));
        return key;
    }

    private DroneState state() {
        return lab.server().house().cloud().drone(drone).orElseThrow();
    }

    private boolean is(LinkState link) {
        return state().link().state() == link;
    }

    /** How many messages were valid, once no more come. */
    private long settled() {
        lab.goOn(Duration.ofSeconds(1));
        return keys.counts().valid();
    }

    private byte[] signedFrame() {
        lab.until("a signed frame went out", SOON, () -> (peer.lastFrame()[2] & 1) == 1);
        return peer.lastFrame();
    }

    @Test
    void aSignedVehicleIsCommandedAsAnyOther() {
        secured();

        ada.does(drone, ARM);

        assertThat(peer.isArmed()).isTrue();
        lab.until(
                "what the server sends is signed",
                Duration.ofSeconds(5),
                () -> peer.signing().good() > 5);
        assertThat(peer.signing().refused()).isZero();
    }

    @Test
    void unsignedFramesDoNotMoveADroneThatMustSign() {
        secured();

        peer.signing().forgetToSign();
        peer.setArmed(true);

        lab.until("the drone falls silent", Duration.ofSeconds(6), () -> is(LinkState.LOST));
        assertThat(keys.counts().unsigned()).isGreaterThan(5);
        assertThat(state().armed()).isFalse();
        assertThat(state().messages())
                .filteredOn(said -> said.text().startsWith("Unsigned messages"))
                .hasSize(1);
    }

    @Test
    void aWrongKeyDoesNotMoveTheDrone() {
        byte[] key = secured();
        byte[] wrong = new byte[key.length];
        Arrays.fill(wrong, (byte) 0x5A);

        peer.signing().use(wrong, peer.signing().now() + 3_600 * SECOND);
        peer.setArmed(true);

        lab.until("the drone falls silent", Duration.ofSeconds(6), () -> is(LinkState.LOST));
        assertThat(keys.counts().badSignature()).isGreaterThan(5);
        assertThat(state().armed()).isFalse();
        peer.signing().use(key, peer.signing().now() + 120 * SECOND);
        lab.until("with the right key it lives again", SOON, () -> is(LinkState.LIVE));
    }

    @Test
    void aReplayedFrameIsRefused() {
        secured();
        byte[] recorded = signedFrame();

        for (int i = 0; i < 3; i++) {
            peer.sayRaw(recorded);
        }

        lab.goOn(SOON);
        assertThat(keys.counts().replayed()).isEqualTo(3);
    }

    @Test
    void aNewLinkMayBeAMinuteBehindAndNoMore() {
        byte[] key = secured();
        byte[] frame = signedFrame();
        long reached = 0;
        for (int i = 6; i > 0; i--) {
            reached = reached << 8 | (frame[frame.length - 13 + i] & 0xFF);
        }
        peer.setSilent(true);
        long before = settled();

        peer.sayRaw(PeerSigning.signedAgain(frame, key, reached - 61 * SECOND, 77));
        assertThat(settled()).isEqualTo(before);
        assertThat(keys.counts().tooOld()).isEqualTo(1);
        peer.sayRaw(PeerSigning.signedAgain(frame, key, reached - 30 * SECOND, 77));
        assertThat(settled()).isEqualTo(before + 1);
        peer.sayRaw(PeerSigning.signedAgain(frame, key, reached - 31 * SECOND, 77));
        assertThat(settled()).isEqualTo(before + 1);
        assertThat(keys.counts().replayed()).isEqualTo(1);
    }

    @Test
    void aRotationInFlightLosesNoFrame() {
        byte[] key = secured();
        ada.does(drone, ARM);
        peer.setSilent(true);
        long validBefore = settled();
        long sentBefore = peer.sent();
        String fingerprint = keys.key().fingerprint();
        peer.setSilent(false);
        peer.goesOn(Duration.ofMillis(10), () -> peer.say(new Attitude(0, 0, 0, 0, 0, 0, 0)));
        lab.until("the vehicle streams", SOON, () -> peer.sent() > sentBefore + 50);

        // The vehicle reads with the new key at once, and the server hears of it late.
        peer.isSlowAfterKeys(Duration.ofMillis(800));
        CommandView[] disarm = new CommandView[1];
        peer.goesOn(Duration.ofMillis(5), () -> {
            if (disarm[0] == null && peer.signing().keys().size() == 2) {
                disarm[0] = ada.give(drone, CommandRequests.disarm());
            }
        });
        LinkSecurityView rotated = keys.rotate();
        CommandView ended = ada.end(disarm[0]);

        assertThat(rotated.key()).isNotNull();
        assertThat(rotated.key().inUse()).isTrue();
        assertThat(rotated.key().fingerprint()).isNotEqualTo(fingerprint);
        assertThat(ended.outcome()).isEqualTo(new CommandView.OutcomeView("succeeded", null, null, null));
        assertThat(peer.isArmed()).isFalse();
        lab.until("it goes on streaming", Duration.ofSeconds(5), () -> peer.sent() > sentBefore + 300);
        peer.setSilent(true);
        assertThat(settled() - validBefore).isEqualTo(peer.sent() - sentBefore);
        Messages counts = keys.counts();
        assertThat(counts).isEqualTo(new Messages(counts.valid(), 0, 0, 0, 0, 0));
        assertThat(peer.signing().keys()).hasSize(2).doesNotHaveDuplicates();
        assertThat(peer.signing().keys().get(0)).isEqualTo(HexFormat.of().formatHex(key));
        assertThat(peer.signing().refused()).isZero();
        assertThat(peer.gaps()).isZero();
    }

    @Test
    void aRotationThatTheVehicleIgnoresKeepsTheOldKey() {
        secured();
        LinkSecurityView.Key before = keys.key();
        peer.signing().ignoreKeys();

        assertThatThrownBy(keys::rotate)
                .isInstanceOfSatisfying(
                        Rejection.class,
                        refused -> assertThat(refused.sentence()).contains("goes on as before"));

        assertThat(keys.key()).isEqualTo(before);
        assertThat(keys.view().nextKey()).isNull();
        assertThat(peer.signing().keys()).hasSizeGreaterThan(1);
        ada.does(drone, ARM);
        assertThat(peer.isArmed()).isTrue();
    }

    @Test
    void aRevokedKeyIsTakenOffTheVehicle() {
        secured();

        LinkSecurityView revoked = keys.revoke();

        assertThat(revoked.policy()).isEqualTo("off");
        assertThat(revoked.key()).isNull();
        assertThat(peer.signing().keys().get(peer.signing().keys().size() - 1)).isEqualTo("0".repeat(64));
        ada.does(drone, ARM);
        assertThat(peer.isArmed()).isTrue();
    }

    @Test
    void requiredIsRefusedForAVehicleThatNeverSigned() {
        keys.make();

        assertThatThrownBy(() -> keys.policy("required"))
                .isInstanceOfSatisfying(
                        Rejection.class,
                        refused -> assertThat(refused.sentence()).contains("never heard to sign"));
    }

    @Test
    void aKeyIsNeverTold() {
        String key = HexFormat.of().formatHex(secured());

        assertThat(lab.server().drones().drones(ada.principal()).toString()).doesNotContainIgnoringCase(key);
        assertThat(keys.view().toString()).doesNotContainIgnoringCase(key);
    }

    @Test
    void aCopterTakesAKeyFliesAndRefusesANewOneWhenArmed() {
        LabDrone copter = lab.ready(lab.add(VehicleSpec.COPTER.insisting()));
        LinkKeys own = new LinkKeys(lab, ada, copter.id());
        own.install();
        own.policy("required");

        ada.takesOff(copter, 8);
        lab.until("it hovers", Duration.ofSeconds(20), () -> copter.height() > 7);
        assertThatThrownBy(own::rotate)
                .isInstanceOfSatisfying(
                        Rejection.class,
                        refused -> assertThat(refused.sentence()).contains("armed"));

        ada.does(copter, CommandRequests.land());
        lab.until("it is down", Duration.ofMinutes(1), copter::isDown);
        Messages counts = own.counts();
        assertThat(counts.valid()).isGreaterThan(30);
        assertThat(counts).isEqualTo(new Messages(counts.valid(), 0, 0, 0, 0, 0));
        assertThat(copter.vehicle().signing().isOn()).isTrue();
        assertThat(copter.vehicle().signing().refused()).isZero();
    }

    @Test
    void theKeyAndItsTimeOutliveACrash() {
        LabDrone px4 = lab.ready(lab.add(VehicleSpec.PX4.insisting()));
        LinkKeys own = new LinkKeys(lab, ada, px4.id());
        own.install();
        own.policy("required");
        String fingerprint = own.key().fingerprint();

        lab.crashServer();
        lab.startServer();

        lab.until(
                "the vehicle lives again",
                Duration.ofSeconds(10),
                () -> px4.known()
                        .filter(state -> state.link().state() == LinkState.LIVE)
                        .isPresent());
        assertThat(own.view().policy()).isEqualTo("required");
        assertThat(own.key()).isEqualTo(new LinkSecurityView.Key(fingerprint, true));
        assertThat(own.counts().unsigned()).isZero();
        assertThat(own.rotate().key()).isNotEqualTo(new LinkSecurityView.Key(fingerprint, true));
    }
}
