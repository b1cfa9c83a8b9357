package org.dronemap.store.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Instant;
import java.util.List;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.operation.JournalEntry;
import org.dronemap.core.operation.OperationId;
import org.dronemap.core.operation.OperationStore;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.operation.SavedOperation.Given;
import org.dronemap.core.operation.SavedOperation.Owner;
import org.dronemap.core.organisation.OrganisationId;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What every {@link OperationStore} keeps to. */
public abstract class OperationStoreContract {
    private static final Instant THEN = Instant.parse("2026-03-04T05:06:07.123456Z");
    private static final OrganisationId OTHERS = new OrganisationId("others");
    private static final List<Given> GIVEN = List.of(
            new Given(new DroneId("copter-1"), new CommandId("run1_upload-1")),
            new Given(new DroneId("copter-2"), new CommandId("run1_upload-2")));

    private OperationStore store;

    protected abstract OperationStore emptyStore();

    @BeforeEach
    void open() {
        store = emptyStore();
    }

    private static SavedOperation operation(String id, OrganisationId organisation, Instant at) {
        return operation(id, "mission", organisation, at);
    }

    private static SavedOperation operation(String id, String kind, OrganisationId organisation, Instant at) {
        return SavedOperation.begun(
                        new OperationId(id), kind, new Owner("ann", "#1", organisation), "roofs, \"all\" 🚁", at)
                .beginning("{\"a\": 1,  \"text is\":\"kept as it is\"}");
    }

    private static JournalEntry entry(long number) {
        return new JournalEntry(number, THEN.plusSeconds(number), "input " + number, "decision " + number);
    }

    private SavedOperation begun(String id) {
        SavedOperation begun = operation(id, OrganisationId.HOME, THEN);
        store.begin(begun, entry(0));
        return begun;
    }

    @Test
    void isEmptyAtFirst() {
        assertThat(store.underWay()).isEmpty();
        assertThat(store.latest(OrganisationId.HOME, "mission", 10)).isEmpty();
        assertThat(store.find(new OperationId("r1"))).isEmpty();
        assertThat(store.journal(new OperationId("r1"), 0, 10)).isEmpty();
        assertThat(store.forgetEndedBefore(THEN)).isZero();
    }

    @Test
    void givesBackAnOperationAndItsJournalAsTheyWere() {
        SavedOperation begun = begun("r1");
        SavedOperation next = begun.next("state 1", GIVEN, null);

        store.append(next, entry(1));

        assertThat(store.find(begun.id())).contains(next);
        assertThat(store.underWay()).containsExactly(next);
        assertThat(store.journal(begun.id(), 0, 10)).containsExactly(entry(0), entry(1));
        assertThat(store.journal(begun.id(), 1, 10)).containsExactly(entry(1));
        assertThat(store.journal(begun.id(), 0, 1)).containsExactly(entry(0));
    }

    @Test
    void writesNeitherStateNorEntryWhenTheEntryDoesNotFollow() {
        SavedOperation begun = begun("r1");
        SavedOperation next = begun.next("state 1", List.of(), null);
        store.append(next, entry(1));

        assertThatThrownBy(() -> store.append(begun.next("another", List.of(), null), entry(1)))
                .isInstanceOf(RuntimeException.class);
        assertThatThrownBy(() -> store.append(next.next("a", List.of(), null).next("b", List.of(), null), entry(3)))
                .isInstanceOf(RuntimeException.class);

        assertThat(store.find(begun.id())).contains(next);
        assertThat(store.journal(begun.id(), 0, 10)).containsExactly(entry(0), entry(1));
    }

    @Test
    void beginsEachOnce() {
        SavedOperation begun = begun("r1");

        assertThatThrownBy(() -> store.begin(operation("r1", OTHERS, THEN.plusSeconds(5)), entry(0)))
                .isInstanceOf(RuntimeException.class);

        assertThat(store.find(begun.id())).contains(begun);
        assertThat(store.journal(begun.id(), 0, 10)).containsExactly(entry(0));
    }

    @Test
    void listsThoseUnderWayOldestFirstAndAnOrganisationsNewestOfAKindFirst() {
        store.begin(operation("late", OrganisationId.HOME, THEN.plusSeconds(60)), entry(0));
        store.begin(operation("theirs", OTHERS, THEN.plusSeconds(30)), entry(0));
        SavedOperation over = begun("over");
        store.append(over.next("end", List.of(), THEN.plusSeconds(9)), entry(1));
        store.begin(operation("early", OrganisationId.HOME, THEN.plusSeconds(10)), entry(0));

        store.begin(operation("other-kind", "follow", OrganisationId.HOME, THEN.plusSeconds(90)), entry(0));

        assertThat(store.underWay())
                .extracting(one -> one.id().value())
                .containsExactly("early", "theirs", "late", "other-kind");
        assertThat(store.latest(OrganisationId.HOME, "mission", 2))
                .extracting(one -> one.id().value())
                .containsExactly("late", "early");
        assertThat(store.latest(OrganisationId.HOME, "follow", 10))
                .extracting(one -> one.id().value())
                .containsExactly("other-kind");
        assertThat(store.latest(OTHERS, "mission", 10))
                .extracting(one -> one.id().value())
                .containsExactly("theirs");
    }

    @Test
    void forgetsOldOnesWithTheirJournalsAndNoneThatIsUnderWay() {
        SavedOperation over = begun("over");
        store.append(over.next("end", List.of(), THEN.plusSeconds(9)), entry(1));
        SavedOperation going = begun("going");

        assertThat(store.forgetEndedBefore(THEN.plusSeconds(9))).isZero();
        assertThat(store.forgetEndedBefore(THEN.plusSeconds(10))).isEqualTo(1);

        assertThat(store.find(over.id())).isEmpty();
        assertThat(store.journal(over.id(), 0, 10)).isEmpty();
        assertThat(store.underWay()).containsExactly(going);
        store.forget(going.id());
        store.forget(going.id());
        assertThat(store.underWay()).isEmpty();
        assertThat(store.journal(going.id(), 0, 10)).isEmpty();
    }
}
