package org.dronemap.proxy;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.Socket;
import java.time.Duration;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BiConsumer;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.SysStatus;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What goes over the wire between the proxy and vehicles, on real sockets. */
class VehicleLinkTest {
    private static final int ARM = 400;
    private static final BiConsumer<PlayedVehicle, Frame> SILENT = (vehicle, frame) -> {};

    private final TestCloud cloud = new TestCloud(0);

    @AfterEach
    void close() {
        cloud.close();
    }

    private PlayedVehicle vehicle(int systemId, BiConsumer<PlayedVehicle, Frame> answers) throws IOException {
        return new PlayedVehicle(
                cloud.udpPort(), new FrameWriter(systemId, 1, 2), PlayedVehicle.copter(4, false), answers);
    }

    /** Hands the arm and disarm commands that come in to {@code then}. */
    private static BiConsumer<PlayedVehicle, Frame> onArm(BiConsumer<PlayedVehicle, CommandLong> then) {
        return (vehicle, frame) -> {
            if (frame.messageId() == CommandLong.ID && CommandLong.decode(frame).command() == ARM) {
                then.accept(vehicle, CommandLong.decode(frame));
            }
        };
    }

    private static void arm(PlayedVehicle vehicle) {
        vehicle.is(PlayedVehicle.copter(4, true));
    }

    @Test
    void showsAVehicleThatCallsIn() throws IOException {
        try (PlayedVehicle vehicle = vehicle(3, SILENT)) {
            vehicle.send(vehicle.heartbeat());
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
    void asksForRatesAndBeatsAsAGroundStation() throws IOException {
        try (PlayedVehicle vehicle = vehicle(1, SILENT)) {
            TestCloud.await(
                    Duration.ofSeconds(10),
                    () -> vehicle.commands(511).stream().anyMatch(ask -> ask.param1() == 33 && ask.param2() == 250_000),
                    () -> "no rate was asked");
            assertThat(vehicle.heard().stream().filter(frame -> frame.messageId() == Heartbeat.ID))
                    .isNotEmpty()
                    .allMatch(frame -> frame.systemId() == 255 && frame.componentId() == 190);
        }
    }

    @Test
    void makesNoDroneOfGroundStationsGimbalsAndTransponders() throws IOException {
        try (PlayedVehicle vehicle = vehicle(1, SILENT)) {
            vehicle.send(PlayedVehicle.copter(4, false));
            try (PlayedVehicle station = new PlayedVehicle(
                            cloud.udpPort(), new FrameWriter(255, 190, 2), new Heartbeat(6, 8, 0, 0, 4, 3), SILENT);
                    PlayedVehicle gimbal = new PlayedVehicle(
                            cloud.udpPort(), new FrameWriter(9, 154, 2), new Heartbeat(26, 8, 0, 0, 4, 3), SILENT);
                    PlayedVehicle transponder = new PlayedVehicle(
                            cloud.udpPort(), new FrameWriter(10, 156, 2), new Heartbeat(27, 8, 0, 0, 4, 3), SILENT)) {
                TestCloud.await(
                        Duration.ofSeconds(10),
                        () -> cloud.proxy().endpoints().get(0).counts().peers() == 4,
                        () -> "not all were heard");
                cloud.awaitDrone(state -> state.link().state() == LinkState.LIVE);

                assertThat(cloud.cloud().drones()).hasSize(1);
                assertThat(station.heard()).isEmpty();
                assertThat(gimbal.heard()).isEmpty();
                assertThat(transponder.heard()).isEmpty();
            }
        }
    }

    @Test
    void keepsTwoVehiclesWithOneSystemIdApartAndCommandsThemSeparately() throws IOException {
        BiConsumer<PlayedVehicle, Frame> arms = onArm((vehicle, command) -> {
            arm(vehicle);
            vehicle.acknowledge(ARM, 0);
        });
        try (PlayedVehicle one = vehicle(1, arms);
                PlayedVehicle other = vehicle(1, arms)) {
            TestCloud.await(Duration.ofSeconds(10), () -> cloud.cloud().drones().size() == 2, () -> "not two");
            DroneState first = cloud.awaitDrone(state -> state.armed() != null);

            assertThat(cloud.command(first.id(), new Command.Arm())).isEqualTo(new Outcome.Succeeded());
            assertThat(one.commands(ARM).size() + other.commands(ARM).size()).isEqualTo(1);
        }
    }

    @Test
    void actsOnceWhenTheFirstTwoAcknowledgementsAreLost() throws IOException {
        AtomicInteger acts = new AtomicInteger();
        try (PlayedVehicle vehicle = vehicle(1, onArm((played, command) -> {
            if (command.confirmation() == 0) {
                acts.incrementAndGet();
            }
            if (command.confirmation() == 2) {
                arm(played);
                played.acknowledge(ARM, 0);
            }
        }))) {
            DroneState drone = cloud.awaitDrone(state -> state.armed() != null);

            assertThat(cloud.command(drone.id(), new Command.Arm())).isEqualTo(new Outcome.Succeeded());
            assertThat(acts).hasValue(1);
            assertThat(vehicle.commands(ARM))
                    .extracting(CommandLong::confirmation)
                    .containsExactly(0, 1, 2);
        }
    }

    @Test
    void passesTheVehiclesOwnSentenceOn() throws IOException {
        try (PlayedVehicle vehicle = vehicle(1, onArm((played, command) -> {
            played.acknowledge(ARM, 4);
            played.say(2, "PreArm: the parrot is asleep 8251");
        }))) {
            DroneState drone = cloud.awaitDrone(state -> state.armed() != null);

            assertThat(cloud.command(drone.id(), new Command.Arm()))
                    .isEqualTo(new Outcome.Refused("vehicle", "PreArm: the parrot is asleep 8251"));
            assertThat(vehicle.commands(ARM)).hasSize(1);
        }
    }

    @Test
    void saysHowLongAVehicleDidNotAnswer() throws IOException {
        try (PlayedVehicle vehicle = vehicle(1, SILENT)) {
            DroneState drone = cloud.awaitDrone(state -> state.armed() != null);

            Outcome outcome = cloud.command(drone.id(), new Command.Arm());

            // Nine, but for a machine so busy that ticks come late.
            int tries = vehicle.commands(ARM).size();
            assertThat(tries).isBetween(5, 9);
            assertThat(outcome)
                    .isEqualTo(new Outcome.TimedOut("No answer from the vehicle within 8 s (" + tries + " tries)."));
        }
    }

    @Test
    void answersAMavlink1VehicleInMavlink1() throws IOException {
        try (PlayedVehicle vehicle = new PlayedVehicle(
                cloud.udpPort(), new FrameWriter(1, 1, 1), PlayedVehicle.copter(4, false), onArm((played, command) -> {
                    arm(played);
                    played.acknowledge(ARM, 0);
                }))) {
            DroneState drone = cloud.awaitDrone(state -> state.armed() != null);

            assertThat(cloud.command(drone.id(), new Command.Arm())).isEqualTo(new Outcome.Succeeded());
            assertThat(vehicle.heard().get(vehicle.heard().size() - 1).version())
                    .isEqualTo(1);
        }
    }

    @Test
    void showsWhatIsUnknownAsUnknown() throws IOException {
        try (PlayedVehicle vehicle = vehicle(1, SILENT)) {
            vehicle.send(vehicle.heartbeat());
            vehicle.send(new GlobalPositionInt(0, 0, 0, 0, 0, 0, 0, 0, 65_535));
            vehicle.send(new SysStatus(0, 0, 0, 0, 12_600, -1, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0));
            DroneState drone = cloud.awaitDrone(state -> state.battery() != null && state.position() != null);

            assertThat(drone.position().point()).isNull();
            assertThat(drone.position().altitudeAmslMeters()).isNull();
            assertThat(drone.battery().percent()).isNull();
            assertThat(drone.battery().amps()).isNull();
            assertThat(drone.battery().volts()).isEqualTo(12.6);
            assertThat(drone.readyToArm()).isNull();
        }
    }

    @Test
    void showsAVehicleOnTcpThoughItsFramesComeInPieces() throws IOException {
        byte[] frame = new FrameWriter(8, 1, 1).frame(PlayedVehicle.copter(6, true));
        try (Socket socket = new Socket("127.0.0.1", cloud.tcpPort())) {
            for (byte one : frame) {
                socket.getOutputStream().write(one);
                socket.getOutputStream().flush();
            }
            DroneState drone = cloud.awaitDrone(state -> state.mode() != null);

            assertThat(drone.link().transport()).isEqualTo("tcp");
            assertThat(drone.link().key().systemId()).isEqualTo(8);
            assertThat(drone.mode()).isEqualTo("RTL");
        }
    }
}
