package org.dronemap.core.conduct;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.operation.JournalEntry;
import org.dronemap.core.operation.JournalReplay;
import org.dronemap.core.operation.OperationCodec;
import org.dronemap.core.operation.OperationDecision;
import org.dronemap.core.operation.OperationKind;
import org.junit.jupiter.api.Test;

class JournalReplayTest {
    private static final OperationCodec<ArmingOperation.State, String> CODEC = ArmingOperation.KIND.codec();

    private static List<JournalEntry> journal(String... inputs) {
        ArmingOperation.State state = ArmingOperation.of(new DroneId("d1"));
        List<JournalEntry> journal = new ArrayList<>(List.of(entry(0, CODEC.state(state), "")));
        for (String input : inputs) {
            OperationDecision<ArmingOperation.State, String> decision =
                    ArmingOperation.KIND.machine().decide(state, input);
            journal.add(entry(journal.size(), input, CODEC.decision(decision)));
            state = decision.next();
        }
        return journal;
    }

    private static JournalEntry entry(long number, String input, String decision) {
        return new JournalEntry(number, Instant.EPOCH, input, decision);
    }

    private static JournalReplay<ArmingOperation.State, String> replay(
            OperationKind<ArmingOperation.State, String> kind, List<JournalEntry> journal) {
        JournalReplay<ArmingOperation.State, String> replay = new JournalReplay<>(kind);
        // In parts, as a long one is read.
        replay.replay(journal.subList(0, 2));
        replay.replay(journal.subList(2, journal.size()));
        return replay;
    }

    @Test
    void decidesAsWasWrittenDown() {
        JournalReplay<ArmingOperation.State, String> replay =
                replay(ArmingOperation.KIND, journal("arm", "note one", "stop"));

        assertThat(replay.difference()).isEmpty();
        assertThat(replay.count()).isEqualTo(4);
    }

    @Test
    void tellsTheFirstEntryThatWasChanged() {
        List<JournalEntry> journal = journal("arm", "note one", "note two");
        journal.set(2, entry(2, "note another", journal.get(2).decision()));

        assertThat(replay(ArmingOperation.KIND, journal).difference()).hasValueSatisfying(difference -> {
            assertThat(difference.number()).isEqualTo(2);
            assertThat(difference.written()).contains("one");
            assertThat(difference.decided()).contains("another");
        });
    }

    @Test
    void tellsThatAnEntryIsMissing() {
        List<JournalEntry> journal = journal("arm", "note one", "note two");
        journal.remove(2);

        assertThat(replay(ArmingOperation.KIND, journal).difference())
                .contains(new JournalReplay.Difference(2, "", "The journal goes on with the entry 3."));
    }

    @Test
    void tellsThatWhatItBeganWithCannotBeRead() {
        List<JournalEntry> journal = journal("arm", "note one");
        journal.set(0, entry(0, "what is this", ""));

        assertThat(replay(ArmingOperation.KIND, journal).difference())
                .hasValueSatisfying(difference -> assertThat(difference.decided())
                        .isEqualTo("It cannot be read: no state of a watch: what is this"));
    }

    @Test
    void tellsWhereAnotherMachineDecidesOtherwise() {
        OperationKind<ArmingOperation.State, String> changed =
                new OperationKind<>("watch", new ArmingOperation(2), CODEC);

        assertThat(replay(changed, journal("note one", "arm")).difference())
                .hasValueSatisfying(
                        difference -> assertThat(difference.number()).isEqualTo(2));
    }
}
