package org.dronemap.proxy.outlet;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.dronemap.core.access.Role;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.MessageTable;
import org.dronemap.mavlink.message.ManualControl;
import org.dronemap.mavlink.message.RcChannelsOverride;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.mavlink.message.SetPositionTargetLocalNed;
import org.dronemap.proxy.outlet.MatrixVehicle.State;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Everything that MAVLink knows, sent by everybody: what comes in at the vehicle's socket is what the committed table says. */
class OutletMatrixTest {
    private static final Map<String, MatrixTestBench.Sender> CASTS = Map.of(
            "stranger", new MatrixTestBench.Sender(Optional.empty(), false),
            "viewer", new MatrixTestBench.Sender(Optional.of(Role.VIEWER), false),
            "planner", new MatrixTestBench.Sender(Optional.of(Role.PLANNER), false),
            "operator without control", new MatrixTestBench.Sender(Optional.of(Role.OPERATOR), false),
            "operator with control", new MatrixTestBench.Sender(Optional.of(Role.OPERATOR), true),
            "operator with control at a personal port",
                    new MatrixTestBench.Sender(Optional.of(Role.OPERATOR), true, true));

    /** What steers, and means something else in a mode that goes by sticks. */
    private static final Set<Integer> STEERING = Set.of(
            ManualControl.ID, RcChannelsOverride.ID, SetPositionTargetLocalNed.ID, SetPositionTargetGlobalInt.ID);

    /** Few enough that what a client may give in a second is not reached. */
    private static final int AT_ONCE = 20;

    private final MatrixTable table = new MatrixTable();

    OutletMatrixTest() throws IOException {}

    static List<String> senders() {
        return MatrixTable.COLUMNS;
    }

    @Test
    void theTableHasEveryMessageOfTheDialect() {
        Map<Integer, String> listed = new LinkedHashMap<>();
        table.rows().stream()
                .filter(row -> row.kind().equals("message"))
                .forEach(row -> listed.put(row.number(), row.name()));
        Map<Integer, String> known = new LinkedHashMap<>();
        MatrixTable.messages().forEach((id, entry) -> known.put(id, MatrixTable.name(entry)));
        assertThat(listed).isEqualTo(known);
    }

    @ParameterizedTest
    @MethodSource("senders")
    void whatReachesTheVehicleIsWhatTheTableSays(String sender) throws IOException {
        Map<MatrixTable.Row, String> column = table.column(sender);
        Map<MatrixTable.Row, Set<String>> reached = new LinkedHashMap<>();
        column.keySet().forEach(row -> reached.put(row, new TreeSet<>()));
        try (MatrixTestBench house = new MatrixTestBench(CASTS.get(sender))) {
            for (State state : State.values()) {
                house.is(state);
                for (List<MatrixTable.Row> rows : batches(state == State.STEERED ? steering(column) : column)) {
                    List<Message> all =
                            rows.stream().flatMap(row -> words(row).stream()).toList();
                    boolean quiet = rows.size() > 1 && house.reached(all).isEmpty();
                    for (MatrixTable.Row row : quiet ? List.<MatrixTable.Row>of() : rows) {
                        one(house, row, column.get(row), reached.get(row));
                    }
                }
            }
        }
        Map<MatrixTable.Row, String> seen = new LinkedHashMap<>();
        reached.forEach((row, kinds) -> seen.put(row, MatrixTable.cell(kinds)));
        MatrixTable.leave(sender, seen);
        assertThat(seen).isEqualTo(column);
    }

    /** That it goes by sticks makes a difference to those alone who steer. */
    private static Map<MatrixTable.Row, String> steering(Map<MatrixTable.Row, String> column) {
        Map<MatrixTable.Row, String> some = new LinkedHashMap<>(column);
        some.keySet().removeIf(row -> !row.kind().equals("message") || !STEERING.contains(row.number()));
        return some;
    }

    /** Each word by itself, until all has come that is to come. */
    private static void one(MatrixTestBench house, MatrixTable.Row row, String expected, Set<String> reached) {
        for (Message word : words(row)) {
            if (expected.isEmpty() || !MatrixTable.cell(reached).equals(expected)) {
                reached.addAll(house.reached(List.of(word)));
            }
        }
    }

    /** Rows that do something go alone; those that do nothing some at a time. */
    private static List<List<MatrixTable.Row>> batches(Map<MatrixTable.Row, String> column) {
        List<List<MatrixTable.Row>> batches = new ArrayList<>();
        List<MatrixTable.Row> quiet = new ArrayList<>();
        column.forEach((row, cell) -> {
            if (cell.isEmpty()) {
                quiet.add(row);
            } else {
                batches.add(List.of(row));
            }
        });
        for (int from = 0; from < quiet.size(); from += AT_ONCE) {
            batches.add(quiet.subList(from, Math.min(quiet.size(), from + AT_ONCE)));
        }
        return batches;
    }

    private static List<Message> words(MatrixTable.Row row) {
        MessageTable.Entry entry = row.kind().equals("message") ? MessageTable.find(row.number()) : null;
        return entry == null ? MatrixMessages.ofCommand(row.number()) : MatrixMessages.ofMessage(entry);
    }
}
