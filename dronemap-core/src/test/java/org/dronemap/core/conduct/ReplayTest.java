package org.dronemap.core.conduct;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.operation.Decision;
import org.dronemap.core.operation.JournalEntry;
import org.dronemap.core.operation.OperationCodec;
import org.dronemap.core.operation.OperationKind;
import org.dronemap.core.operation.Replay;
import org.junit.jupiter.api.Test;

class ReplayTest {
    private static final OperationCodec<Watch.State, String> CODEC = Watch.KIND.codec();

    private static List<JournalEntry> journal(String... inputs) {
        Watch.State state = Watch.of(new DroneId("d1"));
        List<JournalEntry> journal = new ArrayList<>(List.of(entry(0, CODEC.state(state), "")));
        for (String input : inputs) {
            Decision<Watch.State, String> decision = Watch.KIND.machine().decide(state, input);
            journal.add(entry(journal.size(), input, CODEC.decision(decision)));
            state = decision.next();
        }
        return journal;
    }

    private static JournalEntry entry(long number, String input, String decision) {
        return new JournalEntry(number, Instant.EPOCH, input, decision);
    }

    private static Replay<Watch.State, String> replay(
            OperationKind<Watch.State, String> kind, List<JournalEntry> journal) {
        Replay<Watch.State, String> replay = new Replay<>(kind);
        // In parts, as a long one is read.
        replay.take(journal.subList(0, 2));
        replay.take(journal.subList(2, journal.size()));
        return replay;
    }

    @Test
    void decidesAsWasWrittenDown() {
        Replay<Watch.State, String> replay = replay(Watch.KIND, journal("arm", "note one", "stop"));

        assertThat(replay.difference()).isEmpty();
        assertThat(replay.count()).isEqualTo(4);
    }

    @Test
    void tellsTheFirstEntryThatWasChanged() {
        List<JournalEntry> journal = journal("arm", "note one", "note two");
        journal.set(2, entry(2, "note another", journal.get(2).decision()));

        assertThat(replay(Watch.KIND, journal).difference()).hasValueSatisfying(difference -> {
            assertThat(difference.number()).isEqualTo(2);
            assertThat(difference.written()).contains("one");
            assertThat(difference.decided()).contains("another");
        });
    }

    @Test
    void tellsThatAnEntryIsMissing() {
        List<JournalEntry> journal = journal("arm", "note one", "note two");
        journal.remove(2);

        assertThat(replay(Watch.KIND, journal).difference())
                .contains(new Replay.Difference(2, "", "The journal goes on with the entry 3."));
    }

    @Test
    void tellsThatWhatItBeganWithCannotBeRead() {
        List<JournalEntry> journal = journal("arm", "note one");
        journal.set(0, entry(0, "what is this", ""));

        assertThat(replay(Watch.KIND, journal).difference())
                .hasValueSatisfying(difference -> assertThat(difference.decided())
                        .isEqualTo("It cannot be read: no state of a watch: what is this"));
    }

    @Test
    void tellsWhereAnotherMachineDecidesOtherwise() {
        OperationKind<Watch.State, String> changed = new OperationKind<>("watch", new Watch(2), CODEC);

        assertThat(replay(changed, journal("note one", "arm")).difference())
                .hasValueSatisfying(
                        difference -> assertThat(difference.number()).isEqualTo(2));
    }
}
