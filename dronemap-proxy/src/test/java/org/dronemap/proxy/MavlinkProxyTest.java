package org.dronemap.proxy;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.Socket;
import java.util.List;
import java.util.function.BiConsumer;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.AutopilotVersion;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** The wire between the proxy and vehicles, on real sockets; each says at once who it is, as most do. */
class MavlinkProxyTest {
    private static final AutopilotVersion VERSION =
            new AutopilotVersion(0, 0, 0, 0, 0, new int[8], new int[8], new int[8], 0, 0, 0, new int[18]);
    private static final BiConsumer<FakeVehicle, Frame> SILENT = (vehicle, frame) -> {};

    private final TestCloud cloud = new TestCloud(0);

    @AfterEach
    void close() {
        cloud.close();
    }

    private FakeVehicle vehicle(int systemId, BiConsumer<FakeVehicle, Frame> answers) throws IOException {
        return new FakeVehicle(cloud.udpPort(), new FrameWriter(systemId, 1, 2), FakeVehicle.copter(4, false), answers);
    }

    @Test
    void showsAVehicleThatCallsIn() throws IOException {
        try (FakeVehicle vehicle = vehicle(3, SILENT)) {
            vehicle.send(vehicle.heartbeat());
            vehicle.send(VERSION);
            vehicle.send(new GlobalPositionInt(0, 473977420, 85455940, 498_000, 10_000, 0, 0, 0, 0));
            DroneState drone = cloud.awaitDrone(state -> state.position() != null);

            assertThat(drone.name()).isEqualTo("ArduCopter 3");
            assertThat(drone.identification().kind()).isEqualTo(VehicleKind.MULTICOPTER);
            assertThat(drone.mode()).isEqualTo("GUIDED");
            assertThat(drone.armed()).isFalse();
            assertThat(drone.link().transport()).isEqualTo("udp");
            assertThat(drone.battery()).isNull();
        }
    }

    @Test
    void answersAMavlink1VehicleInMavlink1() throws IOException {
        try (FakeVehicle vehicle = new FakeVehicle(
                cloud.udpPort(),
                new FrameWriter(1, 1, 1),
                FakeVehicle.copter(4, false),
                FakeVehicle.onArm((played, command) -> {
                    played.is(FakeVehicle.copter(4, true));
                    played.acknowledge(FakeVehicle.ARM, 0);
                }))) {
            vehicle.send(vehicle.heartbeat());
            vehicle.send(VERSION);
            DroneState drone = cloud.awaitDrone(state -> state.armed() != null);

            assertThat(cloud.command(drone.id(), new Command.Arm())).isEqualTo(new Outcome.Succeeded());
            assertThat(vehicle.heard().get(vehicle.heard().size() - 1).version())
                    .isEqualTo(1);
        }
    }

    @Test
    void showsAVehicleOnTcpThoughItsFramesComeInPieces() throws IOException {
        FrameWriter writer = new FrameWriter(8, 1, 1);
        try (Socket socket = new Socket("127.0.0.1", cloud.tcpPort())) {
            for (Message said : List.of(FakeVehicle.copter(6, true), VERSION)) {
                for (byte one : writer.frame(said)) {
                    socket.getOutputStream().write(one);
                    socket.getOutputStream().flush();
                }
            }
            DroneState drone = cloud.awaitDrone(state -> state.mode() != null);

            assertThat(drone.link().transport()).isEqualTo("tcp");
            assertThat(drone.link().key().systemId()).isEqualTo(8);
            assertThat(drone.mode()).isEqualTo("RTL");
        }
    }
}
