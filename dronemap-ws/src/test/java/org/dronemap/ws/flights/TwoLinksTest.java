package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.LabVehicleLink;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.LinkKeys;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.VehicleSpec;
import org.dronemap.ws.link.DtlsKeyService.DtlsKeyRequest;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** One vehicle on two links at once: one drone, spoken to over the better link, whichever of them breaks. */
class TwoLinksTest {
    private static final LabVehicleLink.Quality WORSE =
            new LabVehicleLink.Quality(0.2, Duration.ofMillis(150), Duration.ofMillis(50));
    private static final LabVehicleLink.Quality FAR =
            new LabVehicleLink.Quality(0, Duration.ofMillis(100), Duration.ZERO);
    /** The share of lost messages is looked at over some seconds before the way is changed. */
    private static final Duration LONGEST_CHOICE = Duration.ofSeconds(30);

    private static final Duration LONGER_THAN_LOST = Duration.ofSeconds(7);

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ada = lab.pilot("ada", Role.ADMINISTRATOR);
    private final LabDrone copter = lab.add(VehicleSpec.COPTER.insisting());

    @AfterEach
    void close() {
        lab.close();
    }

    @Test
    void aDtlsVehicleIsOneDroneOnTheBetterLink() {
        String identity = copterKey();
        copter.wire().is(LabVehicleLink.Kind.dtls(identity));
        LabVehicleLink other = copter.addWire(LabVehicleLink.Kind.dtls(identity));
        lab.ready(copter);
        lab.until("both links are known", Duration.ofSeconds(10), this::isOnBoth);

        fliesOnWhicheverLinkIsLeft(copter.wire(), other);
    }

    /** Of a key that was made for a vehicle on DTLS. */
    private String copterKey() {
        return lab.server()
                .office()
                .dtlsKeys()
                .make(ada.principal(), new DtlsKeyRequest("copter on two links", null))
                .identity();
    }

    @Test
    void aSignedVehicleIsOneDroneOnTheBetterLink() {
        lab.ready(copter);
        LinkKeys keys = new LinkKeys(lab, ada, copter.id());
        keys.install();
        keys.policy("required");
        // The first to bring a signed message has shown something; copies that come later have not.
        copter.wire().is(FAR);
        LabVehicleLink other = copter.addWire(LabVehicleLink.Kind.UDP);
        lab.until("both links are known", Duration.ofSeconds(30), this::isOnBoth);
        copter.wire().is(LabVehicleLink.Quality.GOOD);

        fliesOnWhicheverLinkIsLeft(copter.wire(), other);
        assertThat(keys.counts().badSignature()).isZero();
        assertThat(keys.counts().unsigned()).isZero();
    }

    private boolean isOnBoth() {
        return copter.state().link().others().size() == 1;
    }

    private boolean uses(LabVehicleLink wire) {
        return copter.state().link().key().port() == wire.port();
    }

    private void staysTheOnlyOne() {
        lab.throughout("it is one drone, and never lost", LONGER_THAN_LOST, () -> {
            List<DroneState> drones = lab.server().house().cloud().drones();
            return drones.size() == 1 && drones.get(0).link().state() != LinkState.LOST;
        });
    }

    private void fliesOnWhicheverLinkIsLeft(LabVehicleLink one, LabVehicleLink other) {
        ada.takesOff(copter, 8);
        lab.until("it hovers", Duration.ofSeconds(30), () -> copter.height() > 7);
        LabVehicleLink used = uses(one) ? one : other;
        LabVehicleLink spare = used == one ? other : one;

        // The way in use becomes the worse one: the other is taken.
        used.is(WORSE);
        lab.until("the better link is used", LONGEST_CHOICE, () -> uses(spare));

        // The worse one is cut: nothing changes for anybody.
        used.cut();
        ada.does(copter, CommandRequests.hold());
        staysTheOnlyOne();
        assertThat(uses(spare)).isTrue();

        // It comes back, and the better one is cut in flight: the command given at that moment arrives.
        used.mend();
        lab.until("the worse link is heard again", Duration.ofSeconds(30), this::isOnBoth);
        spare.cut();
        ada.does(copter, CommandRequests.setMode("GUIDED"));
        staysTheOnlyOne();
        assertThat(uses(used)).isTrue();

        ada.fliesTo(copter, copter.place(22, 0), 8);
        lab.until("it is there", Duration.ofMinutes(1), () -> copter.distanceTo(copter.place(22, 0)) < 2);
        ada.does(copter, CommandRequests.land());
        lab.until("it is down", Duration.ofMinutes(1), copter::isDown);
        lab.until(
                "the server knows",
                Duration.ofSeconds(10),
                () -> Boolean.FALSE.equals(copter.state().armed()));
        assertThat(lab.server().house().cloud().drones()).hasSize(1);
    }
}
