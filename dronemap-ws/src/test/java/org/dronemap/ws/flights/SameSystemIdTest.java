package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.LinkKeys;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.SigningPeer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Two vehicles with one system id: two drones, also when both change their address at the same time. */
class SameSystemIdTest {
    private static final Duration LONGEST = Duration.ofSeconds(10);

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ada = lab.pilot("ada", Role.ADMINISTRATOR);

    @AfterEach
    void close() {
        lab.close();
    }

    @Test
    void areToldApartByTheirHardware() {
        SigningPeer one = lab.signingPeer(7).withHardware(0x1111).begin();
        SigningPeer other = lab.signingPeer(7).withHardware(0x2222).begin();
        one.listed();
        other.listed();
        lab.until(
                "their hardware is known",
                LONGEST,
                () -> lab.server().house().cloud().drones().stream()
                        .allMatch(state -> state.identification().hardwareUid() != null));

        eachKeepsItsOwn(one, other);
    }

    @Test
    void areToldApartByTheirSignatures() {
        SigningPeer one = lab.signingPeer(7).begin();
        SigningPeer other = lab.signingPeer(7).begin();
        new LinkKeys(lab, ada, one.listed()).install();
        new LinkKeys(lab, ada, other.listed()).install();

        eachKeepsItsOwn(one, other);
    }

    private void eachKeepsItsOwn(SigningPeer one, SigningPeer other) {
        DroneId first = one.listed();
        DroneId second = other.listed();
        assertThat(first).isNotEqualTo(second);
        for (int round = 0; round < 2; round++) {
            gives(first, one, true);
            gives(second, other, true);
            gives(first, one, false);
            gives(second, other, false);
            one.wire().move();
            other.wire().move();
            lab.until("the first has its drone", LONGEST, () -> has(one, first));
            lab.until("the second has its drone", LONGEST, () -> has(other, second));
        }
        assertThat(lab.server().house().cloud().drones())
                .extracting(DroneState::id)
                .containsExactlyInAnyOrder(first, second);
        assertThat(one.commanded(SigningPeer.ARM)).hasSize(4);
        assertThat(other.commanded(SigningPeer.ARM)).hasSize(4);
    }

    private static boolean has(SigningPeer peer, DroneId drone) {
        return peer.known().filter(state -> state.id().equals(drone)).isPresent();
    }

    private void gives(DroneId drone, SigningPeer peer, boolean arm) {
        ada.does(drone, arm ? CommandRequests.arm() : CommandRequests.disarm());
        assertThat(peer.isArmed()).isEqualTo(arm);
    }
}
