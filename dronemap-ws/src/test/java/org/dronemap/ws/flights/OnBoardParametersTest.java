package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.LinkState;
import org.dronemap.mavlink.message.ParamSet;
import org.dronemap.sim.flight.SimulatedParameters;
import org.dronemap.ws.command.CommandRequest;
import org.dronemap.ws.command.CommandView;
import org.dronemap.ws.command.VehicleDataRequest;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.LabVehicleLink;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.LinkTap;
import org.dronemap.ws.lab.Pilot;
import org.dronemap.ws.lab.VehicleSpec;
import org.dronemap.ws.parameter.ParameterService;
import org.dronemap.ws.parameter.ParametersView;
import org.dronemap.ws.problem.InvalidInput;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Parameters: read, searched, changed with proof, saved and loaded; over good links and over one that breaks. */
class OnBoardParametersTest {
    private static final String AUTOPILOTS = "org.dronemap.ws.lab.VehicleSpec#autopilots";
    private static final int COUNT = 1_000;
    private static final CommandView.OutcomeView SUCCEEDED = new CommandView.OutcomeView("succeeded", null, null, null);

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ann = lab.pilot("ann", Role.OPERATOR);
    private final ParameterService parameters = lab.server().parameters();

    @AfterEach
    void close() {
        lab.close();
    }

    private LabDrone drone(VehicleSpec kit) {
        return lab.ready(lab.add(kit.withParameters(COUNT)));
    }

    private ParametersView shown(LabDrone drone, String search) {
        return parameters.parameters(ann.principal(), drone.id().value(), search);
    }

    private void read(LabDrone drone) {
        CommandView ended = ann.end(parameters.refresh(ann.caller(), drone.id().value()));
        assertThat(ended.outcome()).isEqualTo(SUCCEEDED);
        assertThat(ended.progress()).isEqualTo(new CommandView.ProgressView(COUNT, COUNT));
    }

    private CommandView put(LabDrone drone, String name, double value) {
        return parameters.set(ann.caller(), drone.id().value(), name, new ParameterService.ValueRequest(value, null));
    }

    /** What the vehicle truly has. */
    private static Map<String, Double> held(LabDrone drone) {
        SimulatedParameters all = drone.vehicle().autopilot().parameters();
        Map<String, Double> held = new TreeMap<>();
        IntStream.range(0, all.size())
                .forEach(index -> held.put(all.at(index).name(), all.at(index).value()));
        return held;
    }

    @ParameterizedTest
    @MethodSource(AUTOPILOTS)
    void readsSearchesChangesAndProvesIt(VehicleSpec kit) {
        LabDrone drone = drone(kit);
        assertThat(parameters
                        .parameters(ann.principal(), drone.id().value(), null)
                        .readAt())
                .isNull();
        read(drone);

        assertThat(shown(drone, "0042 spare").total()).isEqualTo(COUNT);
        assertThat(shown(drone, "0042 spare").parameters())
                .extracting(ParametersView.ParameterView::name)
                .containsExactly("SPARE_0042");
        ann.succeeds(put(drone, "SPARE_0042", 0.1));
        ann.succeeds(put(drone, "SPARE_0001", 7));
        assertThat(held(drone).get("SPARE_0042")).isCloseTo(0.1, within(1e-6));
        assertThat(held(drone)).containsEntry("SPARE_0001", 7.0);
        assertThat(shown(drone, "SPARE_0001").parameters())
                .extracting(ParametersView.ParameterView::value)
                .containsExactly(7.0);
    }

    @ParameterizedTest
    @MethodSource(AUTOPILOTS)
    void saysWhatTheVehicleHoldsWhenItSilentlyKeptSomethingElse(VehicleSpec kit) {
        LabDrone drone = drone(kit);
        read(drone);
        drone.vehicle().alterations().alterParameter("SPARE_0003");

        CommandView ended = ann.end(put(drone, "SPARE_0003", 20));

        assertThat(ended.outcome())
                .isEqualTo(new CommandView.OutcomeView(
                        "failed", null, "The vehicle holds SPARE_0003 = 21, not 20.", "command-failed"));
        assertThat(shown(drone, "SPARE_0003").parameters())
                .extracting(ParametersView.ParameterView::value)
                .containsExactly(21.0);
        assertThat(held(drone)).containsEntry("SPARE_0003", 21.0);
    }

    @ParameterizedTest
    @MethodSource(AUTOPILOTS)
    void refusesWhatTheVehicleDoesNotHaveBeforeAnythingIsSent(VehicleSpec kit) {
        LabDrone drone = drone(kit);
        read(drone);
        Map<String, Double> before = held(drone);
        LinkTap tap = drone.wire().tap();

        InvalidInput unknown = catchThrowableOfType(InvalidInput.class, () -> put(drone, "NOBODY", 1));
        InvalidInput broken = catchThrowableOfType(InvalidInput.class, () -> put(drone, "SPARE_0001", 1.5));

        assertThat(unknown.field()).isEqualTo("name");
        assertThat(broken.field()).isEqualTo("value");
        assertThat(broken.allowed()).contains("whole number");
        lab.goOn(Duration.ofSeconds(3));
        assertThat(tap.told(ParamSet.ID, ParamSet::decode)).isEmpty();
        assertThat(held(drone)).isEqualTo(before);
    }

    static Stream<Arguments> autopilotsAndForms() {
        return VehicleSpec.autopilots()
                .flatMap(kit -> Stream.of(Arguments.of(kit, "list"), Arguments.of(kit, "table")));
    }

    @ParameterizedTest
    @MethodSource("autopilotsAndForms")
    void aFileGoesRoundWithABreakInTheMiddle(VehicleSpec kit, String form) {
        LabDrone drone = drone(kit);
        String id = drone.id().value();
        read(drone);
        String saved = parameters.file(ann.principal(), id, form);
        Map<String, Double> before = held(drone);
        ann.does(drone, fiftyEach(100, 200));
        assertThat(held(drone)).isNotEqualTo(before);
        ParametersView.FileView compared = parameters.compare(ann.caller(), id, saved);
        assertThat(compared.different()).hasSizeBetween(90, 100);
        assertThat(compared.same()).isEqualTo(COUNT - compared.different().size());
        assertThat(compared.unknown()).isEmpty();
        assertThat(compared.unfit()).isEmpty();
        assertThat(compared.command()).isNull();

        drone.wire().is(LabVehicleLink.Quality.late(200));
        CommandView loading =
                Objects.requireNonNull(parameters.load(ann.caller(), id, saved).command());
        lab.until("some are written", Duration.ofSeconds(30), () -> isUnderWay(loading));
        assertThat(held(drone)).isNotEqualTo(before);
        drone.wire().cut();
        lab.until(
                "the cut is felt",
                Duration.ofSeconds(10),
                () -> drone.state().link().state() != LinkState.LIVE);
        drone.wire().mend();
        drone.wire().is(LabVehicleLink.Quality.GOOD);

        ann.succeeds(loading);
        assertThat(held(drone)).isEqualTo(before);
        assertThat(parameters.file(ann.principal(), id, form)).isEqualTo(saved);
    }

    @Test
    void aThousandParametersGoUpABadLink() {
        LabDrone drone = drone(VehicleSpec.COPTER);
        String id = drone.id().value();
        read(drone);
        List<String> names = shown(drone, "SPARE").parameters().stream()
                .map(ParametersView.ParameterView::name)
                .toList();
        Map<String, Double> wanted = new TreeMap<>();
        IntStream.range(0, names.size()).forEach(number -> wanted.put(names.get(number), number % 120.0));
        String file = wanted.entrySet().stream()
                .map(line -> line.getKey() + "," + line.getValue())
                .collect(Collectors.joining("\n"));
        drone.wire().is(LabVehicleLink.Quality.BAD);
        drone.wire().doubles(0.02);

        CommandView loading =
                Objects.requireNonNull(parameters.load(ann.caller(), id, file).command());
        lab.until(
                "all is loaded", Duration.ofMinutes(10), () -> ann.now(loading).outcome() != null);

        ann.succeeds(loading);
        assertThat(names).hasSizeGreaterThan(900);
        assertThat(held(drone)).containsAllEntriesOf(wanted);
    }

    private boolean isUnderWay(CommandView loading) {
        CommandView now = ann.now(loading);
        CommandView.ProgressView progress = now.progress();
        return now.outcome() != null || (progress != null && progress.done() > 0);
    }

    private static CommandRequest fiftyEach(int from, int to) {
        List<VehicleDataRequest.ParameterRequest> values = IntStream.range(from, to)
                .mapToObj(number -> new VehicleDataRequest.ParameterRequest(String.format("SPARE_%04d", number), 50.0))
                .toList();
        return new VehicleDataRequest.SetParameters(values, null, null);
    }

    @ParameterizedTest
    @MethodSource(AUTOPILOTS)
    void aParameterOfTheAutopilotsOwnIsChangedAsAnyOther(VehicleSpec kit) {
        LabDrone drone = lab.ready(lab.add(kit));
        String name = kit.isPx4() ? "RTL_RETURN_ALT" : "RTL_ALT";
        ann.succeeds(parameters.refresh(ann.caller(), drone.id().value()));

        ann.succeeds(put(drone, name, 33));

        assertThat(shown(drone, name).parameters())
                .extracting(ParametersView.ParameterView::name, ParametersView.ParameterView::value)
                .containsExactly(org.assertj.core.groups.Tuple.tuple(name, 33.0));
        assertThat(held(drone)).containsEntry(name, 33.0);
    }
}
