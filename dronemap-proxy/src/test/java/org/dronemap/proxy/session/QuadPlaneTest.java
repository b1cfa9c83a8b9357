package org.dronemap.proxy.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.List;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.ExtendedSysState;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.TestCloud;
import org.dronemap.proxy.endpoint.PeerAddress;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** A QuadPlane whose owner has not set Q_MAV_TYPE: its heartbeats say that it is a fixed wing. */
class QuadPlaneTest {
    private static final int FIXED_WING = 1;
    private static final int QUADROTOR = 2;
    private static final int ON_GROUND = 1;

    private final TestCloud cloud = new TestCloud(0);
    private final PeerHandler way = cloud.opened(new CapturingPeer("udp", new PeerAddress("127.0.0.1", 15_911)));
    private final FrameWriter writer = new FrameWriter(1, 1, 2);

    @AfterEach
    void close() {
        cloud.close();
    }

    private void says(Message message) {
        way.received(ByteBuffer.wrap(writer.frame(message)));
    }

    private DroneState becomes(int type, int vtolState, VehicleKind kind) {
        says(new Heartbeat(type, 3, 81, 17, 3, 3));
        cloud.awaitDrone(state -> state.capabilities().known());
        says(new ExtendedSysState(vtolState, ON_GROUND));
        says(new Heartbeat(type, 3, 81, 17, 3, 3));
        TestCloud.await(
                Duration.ofSeconds(30),
                () -> state().identification().kind() == kind && state().phase() != null,
                () -> state().toString());
        return state();
    }

    private DroneState state() {
        List<DroneState> drones = cloud.cloud().drones();
        return drones.get(0);
    }

    @Test
    void whatHasAStateOfItsTransitionTakesOffAndLandsAsACopterDoes() {
        DroneState state = becomes(FIXED_WING, 3, VehicleKind.VTOL);
        assertThat(state.capabilities().commands().contains(Capability.TAKE_OFF))
                .isTrue();
        assertThat(state.capabilities().commands().contains(Capability.LAND)).isTrue();
    }

    @Test
    void planesAndCoptersStayWhatTheySay() {
        assertThat(becomes(FIXED_WING, 0, VehicleKind.FIXED_WING)
                        .capabilities()
                        .commands()
                        .contains(Capability.TAKE_OFF))
                .isFalse();
    }

    @Test
    void copterThatSaysThatItHoversStaysACopter() {
        becomes(QUADROTOR, 3, VehicleKind.MULTICOPTER);
    }
}
