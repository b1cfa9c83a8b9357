package org.dronemap.proxy.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.function.Predicate;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.CommandGate;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.lease.Lease;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.lease.LeaseHolder;
import org.dronemap.core.time.SteppedTime;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.AutopilotVersion;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.TestCloud;
import org.dronemap.proxy.endpoint.PeerAddress;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Which of the components that call themselves a vehicle is the drone. */
class SeveralComponentsTest {
    private static final int AUTOPILOT = 1;
    private static final int SECOND_AUTOPILOT = 2;
    private static final int COMPANION = 191;
    private static final int GIMBAL = 154;
    private static final int ARM = 400;
    private static final int ALT_HOLD = 2;
    private static final Heartbeat CLAIMS_TO_BE_A_COPTER = new Heartbeat(2, 3, 0, 0, 4, 3);
    private static final Heartbeat GUIDED_AND_ARMED = new Heartbeat(2, 3, 0x81, 4, 4, 3);
    private static final Duration BEAT = Duration.ofMillis(500);

    private final SteppedTime time = new SteppedTime(Instant.parse("2026-04-05T06:07:08Z"));
    private final TestCloud cloud = new TestCloud(componentId -> FrameTap.NONE, time);
    private final CapturingPeer peer = new CapturingPeer("udp", new PeerAddress("127.0.0.1", 15_930));
    private final PeerHandler way = cloud.opened(peer);

    @AfterEach
    void close() {
        cloud.close();
        assertThat(time.failures()).isEmpty();
    }

    private void says(int component, Message message) {
        way.received(ByteBuffer.wrap(new FrameWriter(33, component, 2).frame(message)));
    }

    /** So long the runnable speaks twice a second. */
    private void speak(int seconds, Runnable words) {
        for (int i = 0; i < 2 * seconds; i++) {
            words.run();
            time.advance(BEAT);
        }
    }

    private void companion() {
        says(COMPANION, CLAIMS_TO_BE_A_COPTER);
    }

    private void autopilot() {
        says(AUTOPILOT, GUIDED_AND_ARMED);
        says(AUTOPILOT, new GlobalPositionInt(0, 471_000_000, 81_000_000, 500_000, 30_000, 0, 0, 0, 0));
    }

    private DroneState drone() {
        List<DroneState> all = cloud.cloud().drones();
        assertThat(all).hasSize(1);
        return all.get(0);
    }

    private List<Integer> componentsOf(int command) {
        return peer.heard().stream()
                .filter(frame -> frame.messageId() == CommandLong.ID)
                .map(CommandLong::decode)
                .filter(sent -> sent.command() == command)
                .map(CommandLong::targetComponent)
                .distinct()
                .toList();
    }

    private void isTheAutopilot() {
        assertThat(drone().mode()).isEqualTo("GUIDED");
        assertThat(drone().armed()).isTrue();
        assertThat(drone().position()).isNotNull();
        assertThat(drone().link().state()).isEqualTo(LinkState.LIVE);
    }

    @Test
    void theAutopilotIsTheDroneThoughACompanionSpokeFirst() {
        speak(5, this::companion);
        DroneState before = drone();
        speak(4, () -> {
            companion();
            autopilot();
        });
        isTheAutopilot();
        assertThat(drone().id()).isEqualTo(before.id());

        cloud.cloud().gate();
        command(new Command.Disarm(true));
        speak(2, this::autopilot);
        assertThat(componentsOf(ARM)).containsExactly(AUTOPILOT);

        speak(150, this::autopilot);
        isTheAutopilot();
        assertThat(drone().id()).isEqualTo(before.id());
    }

    /** The autopilot's first word is heard, and it has not been made the drone yet. */
    @Test
    void aCommandGivenWhileTheAutopilotTakesOverIsCarriedOutByIt() {
        speak(5, this::companion);
        says(AUTOPILOT, GUIDED_AND_ARMED);
        time.advance(Duration.ofMillis(100));
        command(new Command.Disarm(true));
        speak(4, this::autopilotThatDisarms);

        assertThat(componentsOf(ARM)).containsExactly(AUTOPILOT);
        assertThat(outcome()).isInstanceOf(Outcome.Succeeded.class);
    }

    /** It heard the command, and may have done anything with it. */
    @Test
    void whatTheCompanionWasToldBeforeIsNotKnownAndSaysWhy() {
        speak(5, this::companion);
        command(new Command.Disarm(true));
        time.advance(BEAT);
        speak(4, this::autopilot);

        assertThat(outcome()).isInstanceOf(Outcome.Unknown.class);
        assertThat(outcome().reason())
                .startsWith("It went to another component of the vehicle, which had not answered");
    }

    /** It never became the drone's: the command was not sent to anybody, and says so. */
    @Test
    void aCommandThatNobodyTakesOverHasFailed() {
        speak(5, this::companion);
        says(AUTOPILOT, GUIDED_AND_ARMED);
        command(new Command.Disarm(true));
        time.advance(Duration.ofSeconds(20));

        assertThat(outcome()).isNotNull();
        assertThat(outcome()).isInstanceOfAny(Outcome.Failed.class, Outcome.TimedOut.class);
    }

    private void autopilotThatDisarms() {
        boolean asked = componentsOf(ARM).contains(AUTOPILOT);
        says(AUTOPILOT, asked ? new Heartbeat(2, 3, 1, 4, 3, 3) : GUIDED_AND_ARMED);
        if (asked) {
            says(AUTOPILOT, new CommandAck(ARM, 0, 0, 0, 255, 190));
        }
    }

    private Outcome outcome() {
        return cloud.cloud()
                .gate()
                .find(new CommandId("disarm-1"))
                .orElseThrow()
                .outcome();
    }

    private void command(Command command) {
        cloud.cloud()
                .gate()
                .submit(
                        new CommandGate.Source(new Principal("pilot", Role.OPERATOR), "rest"),
                        drone().id(),
                        new CommandId("disarm-1"),
                        command);
    }

    @Test
    void aCompanionIsNotTheDroneWhenTheAutopilotFallsSilent() {
        speak(4, () -> {
            autopilot();
            companion();
        });
        isTheAutopilot();
        speak(300, this::companion);
        assertThat(drone().link().state()).isEqualTo(LinkState.LOST);
        assertThat(drone().mode()).isEqualTo("GUIDED");
        speak(4, this::autopilot);
        isTheAutopilot();
    }

    @Test
    void aCameraThatCallsItselfACopterGivesWayToTheAutopilotAsWell() {
        speak(4, () -> says(GIMBAL, new Heartbeat(2, 3, 0, 3, 4, 3)));
        speak(4, () -> {
            says(GIMBAL, new Heartbeat(2, 3, 0, 3, 4, 3));
            autopilot();
        });
        isTheAutopilot();
    }

    /** Its first mode is the one that the other component had said: the next is a change all the same. */
    @Test
    void aPilotWhoActsLaterIsNoticedThoughTheAutopilotTookOverInTheSameMode() {
        speak(4, () -> says(GIMBAL, GUIDED_AND_ARMED));
        speak(4, this::autopilot);
        isTheAutopilot();
        cloud.cloud().controls().apply(drone().id(), new LeaseEvent.TakeControl("ann"));
        speak(4, () -> says(AUTOPILOT, new Heartbeat(2, 3, 0x81, ALT_HOLD, 4, 3)));

        assertThat(drone().mode()).isEqualTo("ALT_HOLD");
        assertThat(cloud.cloud().controls().control(drone().id()).tenure())
                .extracting(Lease::holder)
                .isInstanceOf(LeaseHolder.Pilot.class);
    }

    @Test
    void theFirstOfTwoAutopilotsIsTheDroneWhicheverSpeaksFirst() {
        speak(4, () -> says(SECOND_AUTOPILOT, new Heartbeat(2, 3, 0, 0, 4, 3)));
        speak(4, () -> {
            says(SECOND_AUTOPILOT, new Heartbeat(2, 3, 0, 0, 4, 3));
            autopilot();
        });
        isTheAutopilot();
    }

    @Test
    void anAutopilotWithoutTheUsualNumberIsTheDroneToo() {
        speak(4, () -> says(COMPANION, CLAIMS_TO_BE_A_COPTER));
        speak(8, () -> {
            says(COMPANION, CLAIMS_TO_BE_A_COPTER);
            says(SECOND_AUTOPILOT, GUIDED_AND_ARMED);
        });
        assertThat(drone().mode()).isEqualTo("GUIDED");
    }

    @Test
    void anotherFirmwareOnTheSameBoardIsSpokenToInItsOwnWay() {
        speak(4, this::autopilot);
        isTheAutopilot();
        speak(8, () -> says(AUTOPILOT, new Heartbeat(1, 3, 0x81, 11, 4, 3)));
        assertThat(drone().identification().vehicle()).isEqualTo("ArduPlane");
        assertThat(drone().mode()).isEqualTo("RTL");
    }

    @Test
    void theBoardOfACompanionIsNotThatOfTheAutopilot() {
        Predicate<DroneState> known =
                drone -> "c0ffee".equals(drone.identification().hardwareUid());
        speak(4, this::companion);
        speak(4, () -> {
            companion();
            autopilot();
            says(COMPANION, version(0xbad));
            says(AUTOPILOT, version(0xc0ffee));
        });
        assertThat(cloud.cloud().drones()).hasSize(1).allMatch(known);
    }

    /** As a computer that forwards its own version does. */
    private void companionWithABoard() {
        companion();
        says(COMPANION, version(0xbad));
    }

    private List<String> boards() {
        return cloud.cloud().drones().stream()
                .map(drone -> String.valueOf(drone.identification().hardwareUid()))
                .toList();
    }

    @ParameterizedTest
    @ValueSource(ints = {3, 200})
    void aCompanionWithABoardOfItsOwnLeavesNoDroneOfItsOwn(int secondsBefore) {
        speak(secondsBefore, this::companionWithABoard);
        assertThat(boards()).containsExactly("bad");
        DroneState before = drone();

        speak(20, () -> {
            companionWithABoard();
            autopilot();
            says(AUTOPILOT, version(0xc0ffee));
        });

        isTheAutopilot();
        assertThat(boards()).containsExactly("c0ffee");
        assertThat(drone().id()).isEqualTo(before.id());
    }

    @Test
    void aKnownVehicleThatComesBackBehindItsCompanionIsTheOnlyDrone() {
        speak(4, () -> {
            autopilot();
            says(AUTOPILOT, version(0xc0ffee));
        });
        DroneState known = drone();
        time.advance(Duration.ofSeconds(200));
        PeerHandler elsewhere = cloud.opened(new CapturingPeer("udp", new PeerAddress("127.0.0.1", 15_932)));
        FrameWriter companion = new FrameWriter(33, COMPANION, 2);
        FrameWriter autopilot = new FrameWriter(33, AUTOPILOT, 2);
        Runnable board = () -> {
            elsewhere.received(ByteBuffer.wrap(companion.frame(CLAIMS_TO_BE_A_COPTER)));
            elsewhere.received(ByteBuffer.wrap(companion.frame(version(0xbad))));
        };
        speak(150, board);
        assertThat(boards()).containsExactlyInAnyOrder("c0ffee", "bad");

        speak(20, () -> {
            board.run();
            elsewhere.received(ByteBuffer.wrap(autopilot.frame(GUIDED_AND_ARMED)));
            elsewhere.received(ByteBuffer.wrap(autopilot.frame(version(0xc0ffee))));
        });

        assertThat(boards()).containsExactly("c0ffee");
        assertThat(drone().id()).isEqualTo(known.id());
        assertThat(drone().mode()).isEqualTo("GUIDED");
    }

    @Test
    void aGroundStationWithTheNumbersOfTheAutopilotIsNotTheAutopilot() {
        speak(4, () -> {
            autopilot();
            says(AUTOPILOT, new Heartbeat(6, 8, 0, 0, 4, 3));
            says(AUTOPILOT, new Heartbeat(0, 8, 0, 0, 4, 3));
        });
        isTheAutopilot();
    }

    private static AutopilotVersion version(long uid) {
        return new AutopilotVersion(0, 0, 0, 0, 0, new int[8], new int[8], new int[8], 0, 0, uid, new int[18]);
    }
}
