package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.Objects;
import java.util.SplittableRandom;
import java.util.function.BiConsumer;
import java.util.stream.IntStream;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.LinkState;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.ws.command.CommandRequest;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabVehicle;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.LinkTap;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.ScriptedPeer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What the server makes of vehicles that deny, stay silent, lose acknowledgements, or look alike. */
class PeerAnswersTest {
    private static final ScriptedPeer.Answers NONE = (peer, frame) -> {};

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ann = lab.pilot("ann", Role.OPERATOR);

    @AfterEach
    void close() {
        lab.close();
    }

    private ScriptedPeer peer(int systemId, ScriptedPeer.Kind kind, ScriptedPeer.Answers answers) {
        ScriptedPeer peer = lab.peer(systemId, kind, answers);
        lab.until("the peer is listed", Duration.ofSeconds(20), () -> isLive(peer));
        return peer;
    }

    private ScriptedPeer copter(ScriptedPeer.Answers answers) {
        return peer(1, ScriptedPeer.Kind.COPTER, answers);
    }

    private static boolean isLive(LabVehicle vehicle) {
        return vehicle.known()
                .filter(state -> state.link().state() == LinkState.LIVE)
                .isPresent();
    }

    /** Hands the orders to arm and to disarm to {@code then}. */
    private static ScriptedPeer.Answers onArm(BiConsumer<ScriptedPeer, CommandLong> then) {
        return (peer, frame) -> {
            if (isArm(frame)) {
                then.accept(peer, CommandLong.decode(frame));
            }
        };
    }

    private static boolean isArm(Frame frame) {
        return frame.messageId() == CommandLong.ID && CommandLong.decode(frame).command() == ScriptedPeer.ARM_DISARM;
    }

    private CommandView.OutcomeView outcome(LabVehicle vehicle, CommandRequest what) {
        return Objects.requireNonNull(ann.outcome(vehicle, what).outcome());
    }

    private static CommandRequest arm() {
        return CommandRequests.arm();
    }

    @Test
    void theVehiclesOwnSentenceIsWhyItRefused() {
        String sentence = "PreArm: compass 7 of 1 not healthy";
        ScriptedPeer peer = copter(onArm((denying, order) -> {
            denying.says(sentence);
            denying.acknowledges(order.command(), ScriptedPeer.FAILED);
        }));

        CommandView.OutcomeView outcome = outcome(peer, arm());

        assertThat(outcome).isEqualTo(new CommandView.OutcomeView("refused", "vehicle", sentence, "vehicle-failed"));
        assertThat(peer.state().messages()).anyMatch(message -> message.text().equals(sentence));
    }

    @Test
    void aVehicleThatNeverAnswersTimesOutAsStated() {
        ScriptedPeer peer = copter(NONE);
        long began = lab.time().nanos();

        CommandView.OutcomeView outcome = outcome(peer, arm());

        assertThat(outcome.result()).isEqualTo("timedOut");
        assertThat(outcome.reason()).isEqualTo("No answer from the vehicle within 8 s (9 tries).");
        // It did not tell its parameters either, which is waited for once before.
        assertThat(Duration.ofNanos(lab.time().nanos() - began))
                .isBetween(Duration.ofSeconds(8), Duration.ofSeconds(11));
        assertThat(peer.orders(ScriptedPeer.ARM_DISARM))
                .extracting(CommandLong::confirmation)
                .containsExactly(0, 1, 2, 3, 4, 5, 6, 7, 8);
    }

    @Test
    void lostAcknowledgementsDoNotFailWhatWasDone() {
        int[] changes = new int[1];
        ScriptedPeer peer = copter(onArm((forgetful, order) -> {
            if (!forgetful.armed()) {
                changes[0]++;
                forgetful.isArmed(true);
            }
            if (forgetful.orders(ScriptedPeer.ARM_DISARM).size() > 2) {
                forgetful.acknowledges(order.command(), ScriptedPeer.ACCEPTED);
            }
        }));

        ann.does(peer, arm());

        assertThat(changes[0]).isEqualTo(1);
        assertThat(peer.armed()).isTrue();
    }

    @Test
    void theSameCommandIdActsOnce() {
        ScriptedPeer peer = copter(ScriptedPeer.OBEDIENT);
        CommandRequest once = new CommandRequest.Arm("once-8251", null);

        CommandView first = ann.outcome(peer, once);
        CommandView second = ann.outcome(peer, once);

        assertThat(Objects.requireNonNull(first.outcome()).result()).isEqualTo("succeeded");
        assertThat(second.id()).isEqualTo(first.id()).isEqualTo("once-8251");
        assertThat(second.outcome()).isEqualTo(first.outcome());
        assertThat(peer.orders(ScriptedPeer.ARM_DISARM)).hasSize(1);
    }

    @Test
    void twoVehiclesWithOneSystemIdAreTwoDrones() {
        ScriptedPeer one = peer(7, ScriptedPeer.Kind.COPTER, ScriptedPeer.OBEDIENT);
        ScriptedPeer other = peer(7, ScriptedPeer.Kind.COPTER, ScriptedPeer.OBEDIENT);
        assertThat(one.id()).isNotEqualTo(other.id());
        assertThat(one.state().link().key().systemId()).isEqualTo(7);
        assertThat(other.state().link().key().systemId()).isEqualTo(7);

        ann.does(other, arm());

        assertThat(one.orders(ScriptedPeer.ARM_DISARM)).isEmpty();
        assertThat(other.orders(ScriptedPeer.ARM_DISARM)).isNotEmpty();
        assertThat(one.armed()).isFalse();
        assertThat(other.armed()).isTrue();
        assertThat(one.state().armed()).isFalse();
        assertThat(other.state().armed()).isTrue();
    }

    @ParameterizedTest
    @CsvSource({
        "a ground station, 6, 190",
        "a gimbal, 26, 154",
        "an ADS-B receiver, 27, 156",
        "a companion computer, 18, 191"
    })
    void otherComponentsMakeNoDrone(String what, int type, int component) {
        ScriptedPeer stranger = lab.peer(99, new ScriptedPeer.Kind(type, 8, component, 2), ScriptedPeer.OBEDIENT);
        LinkTap tap = stranger.wire().tap();
        ScriptedPeer copter = peer(98, ScriptedPeer.Kind.COPTER, ScriptedPeer.OBEDIENT);

        lab.goOn(Duration.ofSeconds(5));

        assertThat(tap.all()).as(what).isNotEmpty();
        assertThat(stranger.known()).isEmpty();
        assertThat(lab.server().house().cloud().drones()).hasSize(1);
        assertThat(copter.known()).isPresent();
    }

    @Test
    void aSilentVehicleIsLostWithinSixSecondsAndReturns() {
        ScriptedPeer peer = copter(ScriptedPeer.OBEDIENT);
        peer.isSilent(true);

        lab.until("it is lost", Duration.ofSeconds(6), () -> peer.state().link().state() == LinkState.LOST);

        assertThat(ann.refusal(peer, arm())).contains("no contact");
        peer.isSilent(false);
        lab.until("it is back", Duration.ofSeconds(30), () -> isLive(peer));
    }

    @Test
    void aVehicleMayComeByMavlink1() {
        ScriptedPeer peer = peer(1, new ScriptedPeer.Kind(2, 3, 1, 1), ScriptedPeer.OBEDIENT);
        LinkTap tap = peer.wire().tap();

        ann.does(peer, arm());

        assertThat(peer.armed()).isTrue();
        assertThat(peer.state().link().transport()).isEqualTo("udp");
        assertThat(tap.all()).allMatch(heard -> heard.frame().version() == 1);
    }

    @Test
    void brokenBytesDisturbNobody() {
        ScriptedPeer peer = copter(ScriptedPeer.OBEDIENT);
        SplittableRandom chance = new SplittableRandom(1);
        IntStream.range(0, 200).forEach(number -> {
            byte[] broken = new byte[64];
            chance.nextBytes(broken);
            broken[0] = (byte) 0xFD;
            broken[1] = (byte) 0xFF;
            broken[2] = 0;
            broken[3] = 0;
            peer.write(broken);
        });

        ann.does(peer, arm());

        assertThat(peer.armed()).isTrue();
    }

    @Test
    void whatAVehicleDoesNotKnowIsNotDoneAndItIsSaidWhy() {
        ScriptedPeer peer = copter((obeying, frame) -> {
            if (frame.messageId() == CommandLong.ID) {
                ScriptedPeer.OBEDIENT.to(obeying, frame);
            }
        });
        ann.does(peer, arm());

        CommandView.OutcomeView outcome = outcome(peer, CommandRequests.takeOff(10.0));

        assertThat(outcome.result()).isIn("refused", "failed", "timedOut");
        assertThat(outcome.reason()).isNotEmpty();
    }
}
