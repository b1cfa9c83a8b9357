package org.dronemap.ws.follow;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.dronemap.core.access.Principal;
import org.dronemap.core.operation.ReporterState;
import org.dronemap.ws.stream.StreamConnection;
import org.dronemap.ws.stream.StreamEnding;
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
    private final PhoneConnection client = new PhoneConnection();

    /** Connection of a phone that answers when it is told to. */
    private final class PhoneConnection implements StreamConnection {
        private long answeredNanos = now;

        @Override
        public Optional<Principal> principal() {
            return Optional.empty();
        }

        @Override
        public void probe() {
            asked.add("probe");
        }

        @Override
        public long answeredNanos() {
            return answeredNanos;
        }

        @Override
        public long nowNanos() {
            return now;
        }

        @Override
        public <T> T attachment(Class<T> type, Supplier<T> initial) {
            throw new UnsupportedOperationException();
        }
    }

    private void pass(int seconds, boolean answers) {
        for (int second = 0; second < seconds; second++) {
            now += SECOND;
            if (answers) {
                client.answeredNanos = now;
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
        phones.received(client, "f1");
        pass(2, true);
        assertThat(last()).isEqualTo(ReporterState.SPEAKS);
        pass(60, true);
        assertThat(last()).isEqualTo(ReporterState.ASLEEP);
        phones.received(client, "f1");
        assertThat(last()).isEqualTo(ReporterState.SPEAKS);
        assertThat(asked).contains("probe");
    }

    @Test
    void takesOneThatDoesNotAnswerForCut() {
        phones.received(client, "f1");
        pass(4, false);
        assertThat(last()).isEqualTo(ReporterState.CUT);
        phones.disconnected(client, StreamEnding.BROKEN);
        assertThat(last()).isEqualTo(ReporterState.CUT);
    }

    @Test
    void takesOneThatSleptBeforeItsConnectionFellSilentForAsleep() {
        phones.received(client, "f1");
        pass(5, true);
        pass(20, false);
        assertThat(last()).isEqualTo(ReporterState.ASLEEP);
        phones.received(client, "f1");
        pass(4, false);
        assertThat(last()).isEqualTo(ReporterState.CUT);
    }

    @Test
    void takesOneThatEndsItsConnectionForGone() {
        phones.received(client, "f1");
        phones.disconnected(client, StreamEnding.LEFT);
        assertThat(told).containsExactly("f1 SPEAKS", "f1 GONE");
    }

    /** Its last frame is lost with its connection when the server writes into it at that moment. */
    @Test
    void takesOneThatBreaksOffInMidSpeechForGoneAndOneThatHadFallenSilentForCut() {
        phones.received(client, "f1");
        pass(1, true);
        phones.disconnected(client, StreamEnding.BROKEN);
        assertThat(last()).isEqualTo(ReporterState.GONE);
        phones.received(client, "f1");
        now += 4 * SECOND;
        phones.disconnected(client, StreamEnding.BROKEN);
        assertThat(last()).isEqualTo(ReporterState.CUT);
    }

    @Test
    void waitsForOneWhosePageConnectsAnew() {
        phones.received(client, "f1");
        pass(9, true);
        assertThat(last()).isEqualTo(ReporterState.ASLEEP);
        phones.disconnected(client, StreamEnding.RECONNECTING);
        pass(1, false);
        assertThat(last()).isEqualTo(ReporterState.ASLEEP);
        phones.received(new PhoneConnection(), "f1");
        assertThat(last()).isEqualTo(ReporterState.SPEAKS);
        assertThat(told).doesNotContain("f1 GONE");
    }

    @Test
    void takesOneThatSaidThatItConnectsAnewAndDoesNotForCut() {
        phones.received(client, "f1");
        phones.disconnected(client, StreamEnding.RECONNECTING);
        pass(4, false);
        assertThat(last()).isEqualTo(ReporterState.CUT);
    }

    /** As one whose page reads too slowly, since it stands still. */
    @Test
    void doesNotTakeOneForGoneWhoseConnectionTheServerEnds() {
        phones.received(client, "f1");
        pass(9, true);
        phones.disconnected(client, StreamEnding.EXPELLED);
        pass(4, false);
        assertThat(last()).isEqualTo(ReporterState.ASLEEP);
        assertThat(told).doesNotContain("f1 GONE");
    }

    @Test
    void asksNothingOfTheOldConnectionOfOneThatIsThereAnew() {
        phones.received(client, "f1");
        PhoneConnection anew = new PhoneConnection();
        phones.received(anew, "f1");
        phones.disconnected(client, StreamEnding.BROKEN);
        assertThat(last()).isEqualTo(ReporterState.SPEAKS);
    }

    @Test
    void forgetsThoseWhoseFollowIsOver() {
        phones.received(client, "f1");
        underWay = false;
        pass(2, true);
        told.clear();
        pass(5, true);
        assertThat(told).isEmpty();
    }
}
