package org.dronemap.ws.stream;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.operation.ReporterState;
import org.java_websocket.WebSocket;
import org.java_websocket.framing.CloseFrame;
import org.junit.jupiter.api.Test;

class PhoneReachabilityTest {
    private static final long SECOND = 1_000_000_000L;

    private final List<String> told = new ArrayList<>();
    private final List<String> asked = new ArrayList<>();
    private boolean underWay = true;
    private long now = System.nanoTime();
    private final PhoneReachability phones = new PhoneReachability((follow, how) -> {
        told.add(follow + " " + how);
        return underWay;
    });
    private final StreamClient client = client();

    private StreamClient client() {
        WebSocket socket = (WebSocket) Proxy.newProxyInstance(
                WebSocket.class.getClassLoader(), new Class<?>[] {WebSocket.class}, (proxy, method, arguments) -> {
                    asked.add(method.getName());
                    return method.getReturnType() == boolean.class ? Boolean.TRUE : null;
                });
        return new StreamClient(socket, now);
    }

    private void pass(int seconds, boolean answers) {
        for (int second = 0; second < seconds; second++) {
            now += SECOND;
            if (answers) {
                client.answered(now);
            }
            phones.round(now);
        }
    }

    private ReporterState last() {
        String line = told.get(told.size() - 1);
        return ReporterState.valueOf(line.substring(line.indexOf(' ') + 1));
    }

    @Test
    void takesOneThatAnswersAndSaysNothingForAsleep() {
        phones.received(client, "f1", now);
        pass(2, true);
        assertThat(last()).isEqualTo(ReporterState.SPEAKS);
        pass(60, true);
        assertThat(last()).isEqualTo(ReporterState.ASLEEP);
        phones.received(client, "f1", now);
        assertThat(last()).isEqualTo(ReporterState.SPEAKS);
        assertThat(asked).contains("sendPing");
    }

    @Test
    void takesOneThatDoesNotAnswerForCut() {
        phones.received(client, "f1", now);
        pass(4, false);
        assertThat(last()).isEqualTo(ReporterState.CUT);
        phones.disconnected(client, CloseFrame.ABNORMAL_CLOSE, false, now);
        assertThat(last()).isEqualTo(ReporterState.CUT);
    }

    @Test
    void takesOneThatSleptBeforeItsConnectionFellSilentForAsleep() {
        phones.received(client, "f1", now);
        pass(5, true);
        pass(20, false);
        assertThat(last()).isEqualTo(ReporterState.ASLEEP);
        phones.received(client, "f1", now);
        pass(4, false);
        assertThat(last()).isEqualTo(ReporterState.CUT);
    }

    @Test
    void takesOneThatEndsItsConnectionForGone() {
        phones.received(client, "f1", now);
        phones.disconnected(client, CloseFrame.GOING_AWAY, true, now);
        assertThat(told).containsExactly("f1 SPEAKS", "f1 GONE");
    }

    /** Its last frame is lost with its connection when the server writes into it at that moment. */
    @Test
    void takesOneThatBreaksOffInMidSpeechForGoneAndOneThatHadFallenSilentForCut() {
        phones.received(client, "f1", now);
        pass(1, true);
        phones.disconnected(client, CloseFrame.ABNORMAL_CLOSE, false, now);
        assertThat(last()).isEqualTo(ReporterState.GONE);
        phones.received(client, "f1", now);
        now += 4 * SECOND;
        phones.disconnected(client, CloseFrame.ABNORMAL_CLOSE, false, now);
        assertThat(last()).isEqualTo(ReporterState.CUT);
    }

    @Test
    void waitsForOneWhosePageConnectsAnew() {
        phones.received(client, "f1", now);
        pass(9, true);
        assertThat(last()).isEqualTo(ReporterState.ASLEEP);
        phones.disconnected(client, PhoneReachability.CONNECTS_ANEW, true, now);
        pass(1, false);
        assertThat(last()).isEqualTo(ReporterState.ASLEEP);
        phones.received(client(), "f1", now);
        assertThat(last()).isEqualTo(ReporterState.SPEAKS);
        assertThat(told).doesNotContain("f1 GONE");
    }

    @Test
    void takesOneThatSaidThatItConnectsAnewAndDoesNotForCut() {
        phones.received(client, "f1", now);
        phones.disconnected(client, PhoneReachability.CONNECTS_ANEW, true, now);
        pass(4, false);
        assertThat(last()).isEqualTo(ReporterState.CUT);
    }

    /** As one whose page reads too slowly, since it stands still. */
    @Test
    void doesNotTakeOneForGoneWhoseConnectionTheServerEnds() {
        phones.received(client, "f1", now);
        pass(9, true);
        phones.disconnected(client, CloseFrame.POLICY_VALIDATION, false, now);
        pass(4, false);
        assertThat(last()).isEqualTo(ReporterState.ASLEEP);
        assertThat(told).doesNotContain("f1 GONE");
    }

    @Test
    void asksNothingOfTheOldConnectionOfOneThatIsThereAnew() {
        phones.received(client, "f1", now);
        StreamClient anew = client();
        phones.received(anew, "f1", now);
        phones.disconnected(client, CloseFrame.ABNORMAL_CLOSE, false, now);
        assertThat(last()).isEqualTo(ReporterState.SPEAKS);
    }

    @Test
    void forgetsThoseWhoseFollowIsOver() {
        phones.received(client, "f1", now);
        underWay = false;
        pass(2, true);
        told.clear();
        pass(5, true);
        assertThat(told).isEmpty();
    }
}
