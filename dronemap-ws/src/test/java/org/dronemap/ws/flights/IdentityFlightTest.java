package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Objects;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.IdentityEvidence;
import org.dronemap.core.drone.LinkState;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.ws.command.CommandRequest;
import org.dronemap.ws.enrol.EnrolmentService.EnrolRequest;
import org.dronemap.ws.enrol.PendingVehicleView;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabVehicleLink;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.LinkKeys;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.SigningPeer;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RejectionKind;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Who speaks for which drone: addresses that change, forgers, and strangers that wait. */
class IdentityFlightTest {
    private static final long BOARD = 0x5107_0000_0007L;
    private static final int HOME = 473_977_420;
    private static final int HOME_EAST = 85_455_940;
    private static final int ELSEWHERE = 100_000_000;
    /** A new address is believed once the old one has been silent for 1.5 s; until then commands go to the old one. */
    private static final Duration LATEST_TO_AN_OLD_ADDRESS = Duration.ofSeconds(4);

    private static final CommandRequest ARM = CommandRequests.arm();
    private static final CommandRequest DISARM = CommandRequests.disarm();

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ada = lab.pilot("ada", Role.ADMINISTRATOR);

    @AfterEach
    void close() {
        lab.close();
    }

    private SigningPeer copter() {
        return lab.signingPeer(7).withHardware(BOARD).begin();
    }

    private List<DroneState> drones() {
        return lab.server().house().cloud().drones();
    }

    private DroneState only(DroneId drone) {
        assertThat(drones()).extracting(DroneState::id).containsExactly(drone);
        return drones().get(0);
    }

    private boolean isLost(DroneId drone) {
        return only(drone).link().state() == LinkState.LOST;
    }

    private List<PendingVehicleView> waiting() {
        return lab.server().office().waiting().waiting(ada.principal());
    }

    private boolean knowsHardware() {
        return drones().stream().allMatch(state -> state.identification().hardwareUid() != null);
    }

    @Test
    void aVehicleThatChangesItsAddressKeepsItsDrone() {
        SigningPeer copter = copter();
        DroneId drone = copter.listed();
        Instant end = lab.now().plusSeconds(32);
        Instant move = lab.now().plusSeconds(1);
        int moves = 0;

        for (boolean arm = true; lab.now().isBefore(end); arm = !arm) {
            if (!lab.now().isBefore(move)) {
                copter.wire().move();
                moves++;
                move = move.plusSeconds(10);
            }
            ada.does(drone, arm ? ARM : DISARM);
            assertThat(copter.isArmed()).isEqualTo(arm);
            lab.throughout("it is the only one, and not lost", Duration.ofMillis(200), () -> !isLost(drone));
        }

        assertThat(only(drone).link().key().port()).isEqualTo(copter.wire().port());
        assertThat(moves).isGreaterThanOrEqualTo(2);
        assertThat(copter.wire().strays())
                .filteredOn(stray -> stray.after().compareTo(LATEST_TO_AN_OLD_ADDRESS) > 0)
                .allMatch(stray -> SigningPeer.isQuestion(stray.frame()));
    }

    @Test
    void aForgedVehicleMovesNothingAndIsToldNothing() {
        SigningPeer real = copter();
        DroneId drone = real.listed();
        lab.until("its hardware is known", Duration.ofSeconds(10), this::knowsHardware);
        real.isAt(HOME, HOME_EAST);
        lab.until(
                "its position is known",
                Duration.ofSeconds(1),
                () -> only(drone).position() != null);

        SigningPeer forger = copter();
        lab.throughout("the real one is the only one", Duration.ofSeconds(1), () -> isWhereItIs(real, drone));
        for (int i = 0; i < 80; i++) {
            forger.isAt(ELSEWHERE, ELSEWHERE);
            forger.namesItsHardware();
            lab.throughout("the real one is the only one", Duration.ofMillis(100), () -> isWhereItIs(real, drone));
        }

        assertThat(waiting()).singleElement().satisfies(waits -> {
            assertThat(waits.port()).isEqualTo(forger.wire().port());
            assertThat(waits.reason()).isEqualTo("quarantined");
            assertThat(waits.claims()).isEqualTo(drone.value());
        });
        assertThat(only(drone).messages()).anyMatch(said -> said.text().contains("quarantine"));
        ada.does(drone, ARM);
        assertThat(real.isArmed()).isTrue();
        assertThat(forger.isArmed()).isFalse();
        assertThat(forger.received()).isNotEmpty();
        assertThat(forger.toldToAct()).isEmpty();

        real.setSilent(true);
        lab.until("it is lost", Duration.ofSeconds(6), () -> isLost(drone));
        assertThat(only(drone).link().key().port()).isEqualTo(real.wire().port());
        assertThat(forger.toldToAct()).isEmpty();
    }

    private boolean isWhereItIs(SigningPeer real, DroneId drone) {
        DroneState state = only(drone);
        double latitude = Objects.requireNonNull(
                        Objects.requireNonNull(state.position()).point())
                .latitudeDegrees();
        return state.link().key().port() == real.wire().port() && Math.abs(latitude - HOME / 1e7) < 1e-6;
    }

    @Test
    void twoVehiclesWithoutHardwareIdsAndOneSystemIdStayTwo() {
        lab.signingPeer(7).begin();
        lab.signingPeer(7).begin();

        lab.until("both are listed", Duration.ofSeconds(10), () -> drones().size() == 2);
        lab.throughout("they stay two", Duration.ofSeconds(10), () -> drones().size() == 2);
    }

    @Test
    void aSilentDroneThatHasShownProofIsNotGivenToLess() {
        SigningPeer real = copter();
        DroneId drone = real.listed();
        new LinkKeys(lab, ada, drone).install();
        lab.until(
                "the proof counts",
                Duration.ofSeconds(5),
                () -> only(drone).standing().strongest() == IdentityEvidence.SIGNATURE);
        real.setSilent(true);
        lab.until("it is lost", Duration.ofSeconds(6), () -> isLost(drone));

        SigningPeer forger = copter();
        lab.until("the forger waits", Duration.ofSeconds(10), () -> !waiting().isEmpty());

        assertThat(waiting()).singleElement().satisfies(waits -> {
            assertThat(waits.port()).isEqualTo(forger.wire().port());
            assertThat(waits.reason()).isEqualTo("quarantined");
            assertThat(waits.claims()).isEqualTo(drone.value());
        });
        assertThat(isLost(drone)).isTrue();
        assertThat(forger.toldToAct()).isEmpty();
        real.setSilent(false);
        lab.until("it is back", Duration.ofSeconds(5), () -> only(drone).link().state() == LinkState.LIVE);
        ada.does(drone, ARM);
        assertThat(real.isArmed()).isTrue();
        assertThat(forger.isArmed()).isFalse();
    }

    @Test
    void aCommandRightAfterAConnectionCameBackIsCarriedOut() {
        SigningPeer copter =
                lab.signingPeer(7, LabVehicleLink.Kind.TCP).withHardware(BOARD).begin();
        DroneId drone = copter.listed();
        lab.until("its hardware is known", Duration.ofSeconds(10), this::knowsHardware);

        for (boolean armed : List.of(true, false, true, false)) {
            copter.wire().reconnect();
            ada.does(drone, armed ? ARM : DISARM);
            assertThat(copter.isArmed()).isEqualTo(armed);
        }

        assertThat(only(drone).link().transport()).isEqualTo("tcp");
    }

    @Test
    void aStrangerWaitsUntilAnAdministratorLetsItIn() {
        SigningPeer stranger = lab.signingPeer(7, LabVehicleLink.Kind.remote("198.51.100.9"))
                .withHardware(BOARD)
                .begin();

        lab.until("it waits", Duration.ofSeconds(10), () -> !waiting().isEmpty());
        PendingVehicleView waits = waiting().get(0);
        assertThat(waits.reason()).isEqualTo("unknown");
        assertThat(waits.port()).isEqualTo(stranger.wire().port());
        lab.throughout("it is no drone", Duration.ofSeconds(3), () -> drones().isEmpty());
        assertThat(stranger.received(CommandLong.ID)).isNotEmpty();
        assertThat(stranger.toldToAct()).isEmpty();
        Pilot eyes = lab.pilot("eyes", Role.VIEWER);
        assertThatThrownBy(() -> lab.server().office().waiting().waiting(eyes.principal()))
                .isInstanceOfSatisfying(
                        Rejection.class, refused -> assertThat(refused.kind()).isEqualTo(RejectionKind.FORBIDDEN));
        assertThatThrownBy(() -> enrol("nobody"))
                .isInstanceOfSatisfying(
                        Rejection.class, refused -> assertThat(refused.kind()).isEqualTo(RejectionKind.UNKNOWN));

        DroneId drone = enrol(waits.id());
        assertThat(stranger.listed()).isEqualTo(drone);
        ada.does(drone, ARM);
        assertThat(stranger.isArmed()).isTrue();
        assertThat(waiting()).isEmpty();

        // Known again after a restart, without anybody letting it in.
        lab.crashServer();
        lab.startServer();
        assertThat(stranger.listed()).isEqualTo(drone);
        assertThat(only(drone).name()).isEqualTo("Rescue 7");
    }

    private DroneId enrol(String waiting) {
        var drone = lab.server().office().waiting().enrol(ada.principal(), waiting, new EnrolRequest("Rescue 7", null));
        assertThat(drone.name()).isEqualTo("Rescue 7");
        return new DroneId(drone.id());
    }
}
