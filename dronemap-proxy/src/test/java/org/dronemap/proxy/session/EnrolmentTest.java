package org.dronemap.proxy.session;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronemap.core.drone.DroneKey;
import org.dronemap.proxy.endpoint.Peer;
import org.dronemap.proxy.endpoint.PeerAddress;
import org.junit.jupiter.api.Test;

class EnrolmentTest {
    private record Caller(String host, boolean isLocal) implements Peer {
        @Override
        public PeerAddress address() {
            return new PeerAddress(host, 14_550);
        }

        @Override
        public String transport() {
            return "udp";
        }

        @Override
        public void send(byte[] frame) {
            throw new AssertionError("nobody was asked yet");
        }
    }

    private static LinkOrigin from(String host) {
        return LinkOrigin.of(new Caller(host, false), 1);
    }

    @Test
    void letsInByItselfWhoIsOnThisMachineAndNobodyElse() {
        assertThat(Enrolment.LOOPBACK.admits(from("127.0.0.1"))).isTrue();
        assertThat(Enrolment.LOOPBACK.admits(from("0:0:0:0:0:0:0:1"))).isTrue();
        assertThat(Enrolment.LOOPBACK.admits(LinkOrigin.of(new Caller("/dev/ttyACM0", true), 1)))
                .isTrue();
        assertThat(Enrolment.LOOPBACK.admits(from("192.0.2.1"))).isFalse();
        assertThat(Enrolment.LOOPBACK.admits(from("2001:db8::1"))).isFalse();
    }

    @Test
    void letsInEverybodyOrNobodyWhenToldTo() {
        assertThat(Enrolment.EVERYWHERE.admits(from("192.0.2.1"))).isTrue();
        assertThat(Enrolment.NOWHERE.admits(from("127.0.0.1"))).isFalse();
        assertThat(Enrolment.NOWHERE.admits(LinkOrigin.ofReplay("replay", 1, 1)))
                .isTrue();
        assertThat(LinkOrigin.ofReplay("replay", 1, 1).key()).isEqualTo(new DroneKey("replay", 1, 1));
    }
}
