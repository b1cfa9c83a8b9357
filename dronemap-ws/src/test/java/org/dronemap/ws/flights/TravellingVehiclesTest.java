package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.Timesync;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabVehicleLink;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.LinkKeys;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.SigningPeer;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Vehicles whose address changes all the time: none is lost, and no command goes to a wrong place. */
class TravellingVehiclesTest {
    private static final int HOME = 473_977_420;
    private static final int ELSEWHERE = 100_000_000;
    /**
     * So long may it take until nobody speaks to an address that was left: a proof is believed at once and the old link is
     * given up when it is silent for a second; without proof it takes 1.5 s of silence and a claim.
     */
    private static final Duration LATEST_WITH_PROOF = Duration.ofSeconds(4);

    private static final Duration LATEST_WITHOUT_PROOF = Duration.ofSeconds(6);
    /** These hold no order: who is there, how long is the way. */
    private static final Set<Integer> HARMLESS = Set.of(Heartbeat.ID, Timesync.ID);

    private static final Duration FAST = Duration.ofSeconds(2);
    private static final Duration SLOW = Duration.ofSeconds(10);
    private static final Duration LIE = Duration.ofMillis(200);
    private static final Duration JOURNEY = Duration.ofSeconds(26);

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ada = lab.pilot("ada", Role.ADMINISTRATOR);
    private final List<Traveller> all = new ArrayList<>();
    private int changes;

    /** A vehicle on the move, and the drone that the server made of it. */
    private static final class Traveller {
        private final SigningPeer peer;
        private final DroneId drone;
        private int commanded;
        private @Nullable CommandView underWay;

        Traveller(SigningPeer peer, DroneId drone) {
            this.peer = peer;
            this.drone = drone;
        }
    }

    @AfterEach
    void close() {
        lab.close();
    }

    private Traveller traveller(LabVehicleLink.Kind kind) {
        int number = all.size() + 1;
        SigningPeer peer =
                lab.signingPeer(number, kind).withHardware(board(number)).begin();
        Traveller traveller = new Traveller(peer, peer.listed());
        lab.until(
                "its hardware is known",
                Duration.ofSeconds(10),
                () -> now(traveller).identification().hardwareUid() != null);
        all.add(traveller);
        return traveller;
    }

    private static long board(int systemId) {
        return 0x5107_0000_0000L + systemId;
    }

    private Traveller signing(String policy) {
        Traveller traveller = traveller(LabVehicleLink.Kind.UDP);
        LinkKeys keys = new LinkKeys(lab, ada, traveller.drone);
        keys.install();
        keys.policy(policy);
        return traveller;
    }

    /** Says that it is that vehicle: the same system id, the same hardware, at another place. */
    private SigningPeer forger(Traveller victim) {
        int systemId = victim.peer.systemId();
        SigningPeer forger =
                lab.signingPeer(systemId).withHardware(board(systemId)).begin();
        forger.goesOn(LIE, () -> {
            forger.namesItsHardware();
            forger.isAt(ELSEWHERE, ELSEWHERE);
        });
        return forger;
    }

    private void moves(SigningPeer peer, Duration every) {
        peer.goesOn(every, () -> {
            peer.wire().move();
            changes++;
        });
    }

    private DroneState now(Traveller traveller) {
        return lab.server().house().cloud().drone(traveller.drone).orElseThrow();
    }

    @Test
    void keepTheirDrones() {
        Traveller required = signing("required");
        Traveller optional = signing("optional");
        Traveller encrypted = traveller(LabVehicleLink.Kind.dtls("travelling copter"));
        Traveller unproved = traveller(LabVehicleLink.Kind.UDP);
        Traveller another = traveller(LabVehicleLink.Kind.UDP);
        // Nobody commands this one, which changes its address all the same.
        Traveller bystander = traveller(LabVehicleLink.Kind.UDP);
        // The forger of an unproved vehicle stays where it is; against one that moves too, only proof helps.
        List<SigningPeer> forgers = List.of(forger(unproved), forger(required), forger(encrypted));
        forgers.stream().skip(1).forEach(forger -> forger.goesOn(Duration.ofMillis(1_700), forger.wire()::move));
        List.of(required, optional, encrypted).forEach(fast -> moves(fast.peer, FAST));
        List.of(unproved, another, bystander).forEach(slow -> moves(slow.peer, SLOW));
        List<Traveller> commanded = List.of(required, optional, encrypted, unproved, another);

        for (long round = 0; round < JOURNEY.dividedBy(LIE); round++) {
            commanded.forEach(this::command);
            all.forEach(traveller -> traveller.peer.isAt(HOME, HOME));
            lab.throughout("each has its own drone", LIE, this::eachHasItsOwn);
        }

        assertThat(changes).isGreaterThan(40);
        commanded.forEach(traveller -> assertThat(traveller.commanded).isGreaterThan(3));
        List.of(required, optional)
                .forEach(fast -> assertThat(orders(fast, LATEST_WITH_PROOF)).isEmpty());
        List.of(unproved, another, bystander)
                .forEach(slow -> assertThat(orders(slow, LATEST_WITHOUT_PROOF)).isEmpty());
        assertThat(encrypted.peer.wire().strays())
                .allMatch(stray -> stray.after().compareTo(LATEST_WITH_PROOF) <= 0);
        assertThat(bystander.peer.commanded(SigningPeer.ARM)).isEmpty();
        forgers.forEach(forger -> assertThat(forger.commanded(SigningPeer.ARM)).isEmpty());
        all.forEach(traveller -> assertThat(traveller.peer.commanded(SigningPeer.ARM))
                .allMatch(target -> target == traveller.peer.systemId()));
    }

    /** Arms and disarms it again and again; each time it does what it was told. */
    private void command(Traveller traveller) {
        CommandView given = traveller.underWay;
        if (given != null) {
            CommandView.OutcomeView outcome = ada.now(given).outcome();
            if (outcome == null) {
                return;
            }
            assertThat(outcome).isEqualTo(new CommandView.OutcomeView("succeeded", null, null, null));
            assertThat(traveller.peer.isArmed()).isEqualTo(given.type().equals("arm"));
            traveller.commanded++;
        }
        boolean arm = !traveller.peer.isArmed();
        traveller.underWay = ada.give(traveller.drone, arm ? CommandRequests.arm() : CommandRequests.disarm());
    }

    /** Nobody is lost, doubled or moved by a forger. */
    private boolean eachHasItsOwn() {
        List<DroneState> drones = lab.server().house().cloud().drones();
        return drones.size() == all.size()
                && all.stream().allMatch(traveller -> {
                    DroneState state = now(traveller);
                    return state.link().key().systemId() == traveller.peer.systemId()
                            && state.link().state() != LinkState.LOST
                            && isAtHome(state);
                });
    }

    private static boolean isAtHome(DroneState state) {
        if (state.position() == null) {
            return true;
        }
        Geodetic point = Objects.requireNonNull(state.position().point());
        return Math.abs(point.latitudeDegrees() - HOME / 1e7) < 1e-6;
    }

    /** What tells it to do something and came to an address so long after it was left. */
    private static List<LabVehicleLink.Stray> orders(Traveller traveller, Duration latest) {
        return traveller.peer.wire().strays().stream()
                .filter(stray -> stray.after().compareTo(latest) > 0)
                .filter(stray -> !HARMLESS.contains(stray.frame().messageId()))
                .filter(stray -> !SigningPeer.isQuestion(stray.frame()))
                .toList();
    }
}
