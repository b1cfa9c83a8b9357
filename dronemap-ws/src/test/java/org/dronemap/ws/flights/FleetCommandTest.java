package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CompletableFuture;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.ws.command.BroadcastRequest;
import org.dronemap.ws.command.BroadcastView;
import org.dronemap.ws.command.CommandRequest;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.lab.CommandRequests;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.VehicleSpec;
import org.dronemap.ws.problem.InvalidInput;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** One command for a whole fleet: one outcome for each drone. */
class FleetCommandTest {
    private static final List<String> ALL = List.of("all");

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ann = lab.pilot("ann", Role.OPERATOR);

    @AfterEach
    void close() {
        lab.close();
    }

    private List<LabDrone> fleet(int count) {
        List<LabDrone> fleet = IntStream.range(0, count)
                .mapToObj(number -> lab.add(VehicleSpec.COPTER))
                .toList();
        fleet.forEach(lab::ready);
        return fleet;
    }

    private static List<String> ids(List<LabDrone> drones) {
        return drones.stream().map(drone -> drone.id().value()).toList();
    }

    private BroadcastView begin(@Nullable List<String> drones, @Nullable CommandRequest command, @Nullable String id) {
        return lab.server()
                .broadcasts()
                .submit(ann.principal(), "laboratory", new BroadcastRequest(drones, command, id));
    }

    private BroadcastView give(List<String> drones, CommandRequest command, String id) {
        CompletableFuture<BroadcastView> end =
                lab.server().broadcasts().awaitEnd(begin(drones, command, id), Duration.ofSeconds(60));
        lab.until(command.kind() + " has ended for all", Duration.ofSeconds(60), end::isDone);
        return end.join();
    }

    private static CommandView.OutcomeView outcome(BroadcastView.Result result) {
        return Objects.requireNonNull(Objects.requireNonNull(result.command()).outcome());
    }

    @Test
    void twentyDronesGiveTwentyOutcomes() {
        List<LabDrone> fleet = fleet(20);

        BroadcastView armed = give(ALL, CommandRequests.arm(), "arm-all-of-them");

        assertThat(armed.results())
                .extracting(BroadcastView.Result::drone)
                .containsExactlyInAnyOrderElementsOf(ids(fleet));
        assertThat(armed.results())
                .allSatisfy(result -> assertThat(outcome(result).result()).isEqualTo("succeeded"));
        assertThat(armed.results().stream()
                        .map(result -> Objects.requireNonNull(result.command()).id())
                        .distinct())
                .hasSize(20);
        assertThat(fleet).allMatch(drone -> drone.craft().armed());
    }

    @Test
    void eachDroneAnswersForItself() {
        List<LabDrone> fleet = fleet(2);
        String first = fleet.get(0).id().value();
        String second = fleet.get(1).id().value();
        give(List.of(first, second), CommandRequests.arm(), "arm-both");
        give(List.of(first), CommandRequests.disarm(), "disarm-first");

        BroadcastView mixed = give(List.of(second, first, "nobody"), CommandRequests.disarm(), "disarm-all");

        assertThat(mixed.results()).extracting(BroadcastView.Result::drone).containsExactly(second, first, "nobody");
        assertThat(outcome(mixed.results().get(0)).result()).isEqualTo("succeeded");
        CommandView.OutcomeView refused = outcome(mixed.results().get(1));
        assertThat(refused.result()).isEqualTo("refused");
        assertThat(refused.by()).isEqualTo("gate");
        assertThat(mixed.results().get(2).command()).isNull();
        assertThat(mixed.results().get(2).problem()).isEqualTo("There is no drone nobody.");
        assertThat(fleet).noneMatch(drone -> drone.craft().armed());
    }

    @Test
    void theSameIdActsOnceOnEachDrone() {
        List<String> ids = ids(fleet(3));

        BroadcastView first = give(ids, CommandRequests.arm(), "once-8251");
        BroadcastView second = give(ids, CommandRequests.arm(), "once-8251");

        assertThat(first.id()).isEqualTo(second.id()).isEqualTo("once-8251");
        assertThat(second.results())
                .extracting(BroadcastView.Result::command)
                .isEqualTo(first.results().stream()
                        .map(BroadcastView.Result::command)
                        .toList());
        assertThat(ids)
                .allSatisfy(id -> assertThat(given(id))
                        .filteredOn(one -> one.type().equals("arm"))
                        .hasSize(1));
    }

    private List<CommandView> given(String drone) {
        return lab.server().commands().commandsOf(ann.principal(), drone);
    }

    @Test
    void anIdThatNobodyGaveIsTheSameInTheSameFlight() {
        BroadcastRequest land = new BroadcastRequest(ALL, CommandRequests.land(), null);
        try (Laboratory same = new Laboratory(1)) {
            Pilot ben = same.pilot("ben", Role.OPERATOR);

            String id = begin(ALL, CommandRequests.land(), null).id();

            assertThat(id).startsWith("all-").hasSize(22);
            assertThat(same.server()
                            .broadcasts()
                            .submit(ben.principal(), "laboratory", land)
                            .id())
                    .isEqualTo(id);
        }
    }

    static Stream<Arguments> badInput() {
        return Stream.of(
                Arguments.of(null, CommandRequests.arm(), "a-good-id", "drones"),
                Arguments.of(List.of(), CommandRequests.arm(), "a-good-id", "drones"),
                Arguments.of(ALL, null, "a-good-id", "command"),
                Arguments.of(ALL, CommandRequests.takeOff(null), "a-good-id", "command.altitude"),
                Arguments.of(ALL, CommandRequests.arm(), "x", "id"));
    }

    @ParameterizedTest
    @MethodSource("badInput")
    void badInputIsSentToNobody(
            @Nullable List<String> drones, @Nullable CommandRequest command, String id, String field) {
        List<LabDrone> fleet = fleet(2);

        InvalidInput refused = catchThrowableOfType(InvalidInput.class, () -> begin(drones, command, id));

        assertThat(refused.field()).isEqualTo(field);
        lab.goOn(Duration.ofSeconds(3));
        assertThat(ids(fleet)).allSatisfy(drone -> assertThat(given(drone)).isEmpty());
        assertThat(fleet).noneMatch(drone -> drone.craft().armed());
    }
}
