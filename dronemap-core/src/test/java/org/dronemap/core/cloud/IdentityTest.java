package org.dronemap.core.cloud;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import org.dronemap.core.cloud.lane.Lanes;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.cloud.lane.Watchdog;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.IdentityEvidence;
import org.dronemap.core.drone.TextMessage;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.time.SteppedTime;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Who speaks for which drone, and who has to stay outside. */
class IdentityTest {
    private static final Instant BEGAN = Instant.parse("2026-03-04T05:06:07Z");
    private static final long LONG_NANOS = 60_000_000_000L;

    private final SteppedTime time = new SteppedTime(BEGAN);
    private final Lanes lanes = new Lanes(time, 2);
    private final StoreWriter journal = new StoreWriter(time);
    private final CloudFixtures.InMemoryDroneStore store = new CloudFixtures.InMemoryDroneStore();
    private final AtomicInteger numbers = new AtomicInteger();
    private final CloudManager cloud = manager();

    @AfterEach
    void close() {
        lanes.close();
        journal.close();
    }

    private CloudManager manager() {
        return new CloudManager(
                lanes,
                new Watchdog(Duration.ofMinutes(1), Duration.ofMinutes(1), Duration.ofMinutes(2)),
                time,
                new CloudManager.Persistence(
                        store,
                        new CloudFixtures.InMemoryCommandStore(),
                        new CloudFixtures.InMemoryLeaseStore(),
                        new CloudFixtures.InMemoryParameterOverrideStore(),
                        journal),
                () -> new DroneId("drone-" + numbers.incrementAndGet()));
    }

    private static Claim claim(int port, @Nullable String uid, @Nullable IdentityProof proof, boolean trusted) {
        LinkSession session = new LinkSession(
                new DroneKey("192.0.2.7", port, 1), "udp", false, "ArduCopter 1", new CloudFixtures.RecordingChannel());
        return new Claim(session, CloudFixtures.copter(uid), proof, trusted, LONG_NANOS);
    }

    /** Heard for so short a time that the drone may just have moved there. */
    private static Claim newcomer() {
        Claim claim = claim(6001, "aa01", null, true);
        return new Claim(claim.session(), claim.identification(), null, true, 0);
    }

    private DroneLink letIn(int port, @Nullable String uid, @Nullable IdentityProof proof) {
        DroneLink link = CloudFixtures.bound(cloud.admit(claim(port, uid, proof, true)));
        onLane(link, () -> {});
        return link;
    }

    private void onLane(DroneLink link, Runnable work) {
        link.lane().execute(work);
        time.settle();
    }

    private void until(BooleanSupplier holds) {
        SteppedUntil.until(time, holds);
    }

    private void keepAlive(DroneLink link) {
        onLane(link, () -> link.lane().addTimedTask(link::received));
    }

    private DroneState state(DroneLink link) {
        return cloud.drone(link.id()).orElseThrow();
    }

    @Test
    void believesHardwareAtANewAddressOnlyWhenTheOldOneHasBeenSilent() {
        DroneLink before = letIn(5001, "aa01", null);

        long began = time.nanos();
        assertThat(cloud.admit(newcomer())).isInstanceOf(ClaimResult.NotAdmitted.class);
        until(() -> cloud.admit(newcomer()) instanceof ClaimResult.Bound bound
                && bound.link().id().equals(before.id()));

        assertThat(time.nanos() - began).isGreaterThan(1_200_000_000L);
        until(() -> state(before).link().key().port() == 6001);
    }

    @Test
    void quarantinesWhoClaimsTheHardwareOfALiveDroneAndSaysSoOnce() {
        DroneLink real = letIn(5001, "aa01", null);
        keepAlive(real);
        until(() -> cloud.admit(claim(6001, "aa01", null, true)) instanceof ClaimResult.NotAdmitted
                && cloud.waiting().stream().anyMatch(WaitingVehicle::isQuarantined));
        cloud.admit(claim(6001, "aa01", null, true));
        onLane(real, () -> {});

        assertThat(cloud.waiting()).singleElement().satisfies(waiting -> {
            assertThat(waiting.claims()).isEqualTo(real.id());
            assertThat(waiting.key().port()).isEqualTo(6001);
        });
        assertThat(state(real).link().key().port()).isEqualTo(5001);
        assertThat(state(real).messages())
                .extracting(TextMessage::text)
                .filteredOn(text -> text.contains("quarantine"))
                .hasSize(1);
        assertThat(cloud.drones()).hasSize(1);
    }

    @Test
    void keepsAForgerOutEvenWhenTheRealOneFallsSilent() {
        DroneLink real = letIn(5001, "aa01", null);
        onLane(real, () -> {});
        cloud.admit(claim(6001, "aa01", null, true));
        assertThat(cloud.waiting()).singleElement().matches(WaitingVehicle::isQuarantined);

        time.advance(Duration.ofMillis(1_700));

        assertThat(cloud.admit(claim(6001, "aa01", null, true))).isInstanceOf(ClaimResult.NotAdmitted.class);
        assertThat(cloud.admit(claim(7001, "aa01", null, true)))
                .isInstanceOfSatisfying(
                        ClaimResult.Bound.class,
                        bound -> assertThat(bound.link().id()).isEqualTo(real.id()));
    }

    @Test
    void believesProofAtOnceAndNeverAgainLess() {
        DroneLink first = letIn(5001, "aa01", new IdentityProof.OfLink("key 7"));
        keepAlive(first);

        DroneLink second = letIn(6001, null, new IdentityProof.OfLink("key 7"));

        assertThat(second.id()).isEqualTo(first.id());
        assertThat(state(first).standing().strongest()).isEqualTo(IdentityEvidence.LINK);
        for (int port : new int[] {5001, 8001}) {
            assertThat(cloud.admit(claim(port, "aa01", null, true))).isInstanceOf(ClaimResult.NotAdmitted.class);
        }
        assertThat(cloud.waiting()).hasSize(2).allMatch(WaitingVehicle::isQuarantined);
    }

    @Test
    void believesASignatureOfTheDronesKeyFromAnywhere() {
        DroneLink first = letIn(5001, null, null);
        keepAlive(first);

        assertThat(letIn(6001, null, new IdentityProof.OfSignature(first.id())).id())
                .isEqualTo(first.id());
        assertThat(state(first).standing().strongest()).isEqualTo(IdentityEvidence.SIGNATURE);
    }

    @Test
    void givesADroneThatHasSignedToNobodyWhoDoesNot() {
        DroneLink link = letIn(5001, "aa01", null);
        onLane(link, () -> link.proved(new IdentityProof.OfSignature(link.id())));
        keepAlive(link);

        for (int port : new int[] {5001, 8001}) {
            assertThat(cloud.admit(claim(port, "aa01", null, true))).isInstanceOf(ClaimResult.NotAdmitted.class);
        }
        assertThat(cloud.waiting())
                .hasSize(2)
                .allSatisfy(waiting -> assertThat(waiting.why()).contains("has shown proof before"));
    }

    @Test
    void makesNoOneDroneOfTwoVehiclesThatShareAKey() {
        DroneLink first = letIn(5001, null, new IdentityProof.OfLink("key 7"));
        keepAlive(first);
        LinkSession twin = new LinkSession(
                new DroneKey("192.0.2.7", 6001, 2),
                "dtls",
                false,
                "ArduCopter 2",
                new CloudFixtures.RecordingChannel());

        assertThat(cloud.admit(new Claim(
                        twin, CloudFixtures.copter(null), new IdentityProof.OfLink("key 7"), true, LONG_NANOS)))
                .isInstanceOf(ClaimResult.NotAdmitted.class);

        assertThat(cloud.waiting())
                .singleElement()
                .satisfies(waiting -> assertThat(waiting.why()).contains("a key of its own"));
        assertThat(state(first).link().key().port()).isEqualTo(5001);
    }

    @Test
    void believesAKeyThatWasMadeForADrone() {
        DroneLink first = letIn(5001, "aa01", null);
        keepAlive(first);

        DroneLink second =
                letIn(6001, "aa01", new IdentityProof.OfLink(first.id().value()));

        assertThat(second.id()).isEqualTo(first.id());
        assertThat(state(first).standing().strongest()).isEqualTo(IdentityEvidence.LINK);
    }

    @Test
    void givesADroneToNobodyWithTheKeyOfAnotherVehicle() {
        DroneLink real = letIn(5001, "aa01", new IdentityProof.OfLink("key 7"));
        until(() -> state(real).standing().linkIdentity() != null);
        time.advance(Duration.ofMillis(1_700));

        for (int port : new int[] {5001, 6001}) {
            assertThat(letIn(port, "aa01", new IdentityProof.OfLink("key of " + port))
                            .id())
                    .isNotEqualTo(real.id());
        }
    }

    @Test
    void remembersProofOverARestart() {
        DroneLink link = letIn(5001, "aa01", new IdentityProof.OfLink("key 7"));
        until(() -> !store.drones().isEmpty());

        CloudManager restarted = manager();

        assertThat(restarted.admit(claim(5001, "aa01", null, true))).isInstanceOf(ClaimResult.NotAdmitted.class);
        assertThat(restarted.admit(claim(9001, null, new IdentityProof.OfLink("key 7"), false)))
                .isInstanceOfSatisfying(
                        ClaimResult.Bound.class,
                        bound -> assertThat(bound.link().id()).isEqualTo(link.id()));
    }

    @Test
    void letsAStrangerWaitUntilSomebodyLetsItIn() {
        assertThat(cloud.admit(claim(5001, "aa01", null, false))).isInstanceOf(ClaimResult.NotAdmitted.class);
        assertThat(cloud.drones()).isEmpty();
        WaitingVehicle waiting = cloud.waiting().get(0);
        assertThat(waiting.isQuarantined()).isFalse();

        DroneState enrolled = cloud.admit(waiting.id(), "Rescue 7").orElseThrow();

        assertThat(cloud.waiting()).isEmpty();
        assertThat(enrolled.name()).isEqualTo("Rescue 7");
        assertThat(CloudFixtures.bound(cloud.admit(claim(5001, "aa01", null, false)))
                        .id())
                .isEqualTo(enrolled.id());
        assertThat(cloud.admit(waiting.id(), "again")).isEmpty();
    }

    @Test
    void letsAStrangerWithALinkKeyInByItself() {
        assertThat(cloud.admit(claim(5001, null, new IdentityProof.OfLink("key 8"), false)))
                .isInstanceOf(ClaimResult.Bound.class);
    }

    @Test
    void keepsWhoWasLetInFromQuarantineADroneOfItsOwn() {
        DroneLink real = letIn(5001, "aa01", null);
        keepAlive(real);
        until(() -> cloud.admit(claim(6001, "aa01", null, true)) instanceof ClaimResult.NotAdmitted
                && cloud.waiting().stream().anyMatch(WaitingVehicle::isQuarantined));

        DroneState twin = cloud.admit(cloud.waiting().get(0).id(), null).orElseThrow();

        DroneLink link = letIn(6001, "aa01", null);
        assertThat(link.id()).isEqualTo(twin.id()).isNotEqualTo(real.id());
        onLane(link, () -> link.accept(new DroneEvent.Identified(CloudFixtures.copter("aa01"), CloudFixtures.ALL)));
        assertThat(letIn(5001, "aa01", null).id()).isEqualTo(real.id());
    }

    @Test
    void boundsTheWaitingRoomForEachAddress() {
        for (int port = 1; port <= 100; port++) {
            cloud.admit(claim(port, null, null, false));
        }
        assertThat(cloud.waiting()).hasSize(20);
    }

    @Test
    void takesADroneBackThatWasOnlyMadeForSomebodyElse() {
        DroneLink made = letIn(5001, null, null);

        made.withdraw();

        assertThat(cloud.drones()).isEmpty();
    }

    @Test
    void doesNotTakeBackADroneThatWasKnownBefore() {
        letIn(5001, null, null);
        until(() -> !store.drones().isEmpty());
        CloudManager restarted = manager();

        CloudFixtures.bound(restarted.admit(claim(5001, null, null, true))).withdraw();

        assertThat(restarted.drones()).hasSize(1);
    }

    @Test
    void makesOneDroneOfTwoLinksOfOneKeyThatComeAtOnce() {
        IdentityProof.OfLink key = new IdentityProof.OfLink("v1");

        // No lane gets to its work in between.
        DroneLink one = CloudFixtures.bound(cloud.admit(claim(8001, "aa01", key, true)));
        DroneLink other = CloudFixtures.bound(cloud.admit(claim(8002, "aa01", key, true)));
        DroneLink bare = CloudFixtures.bound(cloud.admit(claim(8003, null, key, true)));

        assertThat(other.id()).isEqualTo(one.id());
        assertThat(bare.id()).as("by the key alone").isEqualTo(one.id());
    }

    @Test
    void makesTheDroneThatAKeyWasIssuedForAndNoOtherAtTheSameAddress() {
        DroneLink before = letIn(5001, null, null);
        time.advance(Duration.ofMillis(1_700));
        DroneId issuedFor = new DroneId("drobot0001");
        IdentityProof.OfLink key = new IdentityProof.OfLink("drobot0001", issuedFor);

        DroneLink robot = CloudFixtures.bound(cloud.admit(claim(5001, null, key, false)));

        assertThat(robot.id()).isEqualTo(issuedFor).isNotEqualTo(before.id());
        assertThat(state(before).standing().strongest()).isEqualTo(IdentityEvidence.ADDRESS);
        assertThat(CloudFixtures.bound(cloud.admit(claim(6001, null, key, false)))
                        .id())
                .isEqualTo(issuedFor);
    }
}
