package org.dronemap.proxy.mavlink.procedure;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BiConsumer;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.VehicleLog;
import org.dronemap.core.parameter.ParameterValue;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.HomePosition;
import org.dronemap.mavlink.message.MissionItemInt;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/** Every procedure, with every message of it lost, late, doubled and overtaken once. */
class EveryFaultTest {
    private static final int COMMAND = 181;
    private static final Outcome DONE = new Outcome.Succeeded();

    /** One conversation with a vehicle of its own, and what must be true at its end. */
    private record FaultCase(
            String name, Function<TestWire, Exchange> begin, BiConsumer<TestWire, @Nullable Outcome> judge) {}

    @TestFactory
    Stream<DynamicTest> comesToTheRightEnd() {
        return Stream.<Supplier<FaultCase>>of(
                        EveryFaultTest::repeatableCommand,
                        EveryFaultTest::onceOnlyCommand,
                        EveryFaultTest::upload,
                        EveryFaultTest::partialUpload,
                        EveryFaultTest::homeReading,
                        () -> download(false),
                        () -> download(true),
                        EveryFaultTest::clear,
                        EveryFaultTest::listing,
                        EveryFaultTest::writing,
                        EveryFaultTest::writingOfAnAlteredParameter,
                        EveryFaultTest::logListing,
                        EveryFaultTest::logDownload)
                .flatMap(EveryFaultTest::everyFaultOf);
    }

    private static Stream<DynamicTest> everyFaultOf(Supplier<FaultCase> conversation) {
        int messages = run(conversation.get(), wire -> {}).crossed();
        assertThat(messages).as("messages of " + conversation.get().name()).isGreaterThan(1);
        return Stream.of(MessageFault.values())
                .flatMap(fault -> IntStream.range(0, messages)
                        .mapToObj(number -> DynamicTest.dynamicTest(
                                conversation.get().name() + ", message " + number + " " + fault,
                                () -> run(conversation.get(), wire -> wire.fault(fault, number)))));
    }

    private static TestWire run(FaultCase conversation, java.util.function.Consumer<TestWire> prepare) {
        TestWire wire = new TestWire();
        prepare.accept(wire);
        Exchange exchange = conversation.begin().apply(wire);
        Outcome outcome = wire.runWhole(exchange);
        conversation.judge().accept(wire, outcome);
        return wire;
    }

    private static FaultCase repeatableCommand() {
        AtomicInteger acted = new AtomicInteger();
        return new FaultCase("repeatable command", wire -> command(wire, acted, false), (wire, outcome) -> {
            assertThat(outcome).isEqualTo(DONE);
            assertThat(acted).hasPositiveValue();
        });
    }

    private static FaultCase onceOnlyCommand() {
        AtomicInteger acted = new AtomicInteger();
        return new FaultCase("once-only command", wire -> command(wire, acted, true), (wire, outcome) -> {
            assertThat(wire.sent()).hasSize(1);
            if (outcome instanceof Outcome.Succeeded) {
                assertThat(acted).hasPositiveValue();
            } else {
                assertThat(outcome).isInstanceOf(Outcome.Unknown.class);
            }
        });
    }

    private static Exchange command(TestWire wire, AtomicInteger acted, boolean once) {
        wire.peer((w, message) -> {
            acted.incrementAndGet();
            w.answer(new CommandAck(COMMAND, 0, 0, 0, 255, 190));
        });
        MavCommandRequest request = MavCommandRequest.ofLong(
                wire.target(),
                COMMAND,
                new float[] {1f},
                once ? MavCommandRequest.Retry.ONCE : MavCommandRequest.Retry.REPEATABLE,
                MavCommandRequest.CompletionCheck.ACKNOWLEDGED);
        return new CommandExchange(wire.target(), request, ExchangeObserver.NONE);
    }

    private static List<MissionItemInt> items() {
        return IntStream.range(0, 5)
                .mapToObj(seq -> new MissionItemInt(1, 1, seq, 3, 16, 0, 1, 0f, 0f, 0f, 0f, 10 + seq, 20, 30f, 0))
                .toList();
    }

    private static FaultCase upload() {
        MissionVehicle vehicle = new MissionVehicle();
        return new FaultCase(
                "mission upload",
                wire -> {
                    wire.peer(vehicle::take);
                    return new MissionUpload(wire.target(), MavMissionType.MISSION, items(), ExchangeObserver.NONE);
                },
                (wire, outcome) -> {
                    assertThat(outcome).isEqualTo(DONE);
                    assertThat(vehicle.held).isEqualTo(items());
                });
    }

    private static FaultCase partialUpload() {
        MissionVehicle vehicle = new MissionVehicle();
        vehicle.held = new ArrayList<>(otherItems());
        return new FaultCase(
                "partial mission upload",
                wire -> {
                    wire.peer(vehicle::take);
                    return MissionUpload.part(
                            wire.target(),
                            MavMissionType.MISSION,
                            items(),
                            new MissionUpload.Span(1, 2),
                            ExchangeObserver.NONE);
                },
                (wire, outcome) -> {
                    assertThat(outcome).isEqualTo(DONE);
                    List<MissionItemInt> spliced = new ArrayList<>(otherItems());
                    spliced.set(1, items().get(1));
                    spliced.set(2, items().get(2));
                    assertThat(vehicle.held).isEqualTo(spliced);
                });
    }

    private static List<MissionItemInt> otherItems() {
        return IntStream.range(0, 5)
                .mapToObj(seq -> new MissionItemInt(1, 1, seq, 3, 16, 0, 1, 0f, 0f, 0f, 0f, 90 + seq, 20, 30f, 0))
                .toList();
    }

    private static FaultCase homeReading() {
        return new FaultCase(
                "home reading",
                wire -> {
                    wire.peer((w, message) ->
                            w.answer(new HomePosition(10, 20, 30_000, 0f, 0f, 0f, new float[4], 0f, 0f, 0f, 0L)));
                    return new HomeRead(wire.target(), home -> home.latitude() == 10, home -> "elsewhere");
                },
                (wire, outcome) -> assertThat(outcome).isEqualTo(DONE));
    }

    private static FaultCase download(boolean inAnyOrder) {
        MissionVehicle vehicle = new MissionVehicle();
        vehicle.held = new ArrayList<>(items());
        List<MissionDownload> made = new ArrayList<>();
        return new FaultCase(
                inAnyOrder ? "mission download in any order" : "mission download",
                wire -> {
                    wire.peer(vehicle::take);
                    made.add(MissionDownload.whole(wire.target(), MavMissionType.MISSION));
                    if (inAnyOrder) {
                        wire.target().roundTrip().measured(400_000_000L);
                        made.get(0).inAnyOrder();
                    }
                    return made.get(0);
                },
                (wire, outcome) -> {
                    assertThat(outcome).isEqualTo(DONE);
                    assertThat(made.get(0).items()).isEqualTo(items());
                });
    }

    private static FaultCase clear() {
        MissionVehicle vehicle = new MissionVehicle();
        vehicle.held = new ArrayList<>(items());
        return new FaultCase(
                "mission clear",
                wire -> {
                    wire.peer(vehicle::take);
                    return new MissionClear(wire.target(), MavMissionType.MISSION);
                },
                (wire, outcome) -> {
                    assertThat(outcome).isEqualTo(DONE);
                    assertThat(vehicle.held).isEmpty();
                });
    }

    private static FaultCase listing() {
        ParameterVehicle vehicle = ParameterVehicle.with(20, false);
        List<ParameterDownload> made = new ArrayList<>();
        return new FaultCase(
                "parameter list",
                wire -> {
                    wire.peer(vehicle::take);
                    made.add(new ParameterDownload(wire.target(), vehicle.codec, ExchangeObserver.NONE));
                    return made.get(0);
                },
                (wire, outcome) -> {
                    assertThat(outcome).isEqualTo(DONE);
                    assertThat(made.get(0).parameters()).containsExactlyElementsOf(vehicle.held.values());
                });
    }

    private static FaultCase writing() {
        ParameterVehicle vehicle = ParameterVehicle.with(6, true);
        return new FaultCase("parameter change", wire -> write(wire, vehicle), (wire, outcome) -> {
            assertThat(outcome).isEqualTo(DONE);
            assertThat(vehicle.held.get("P_1")).extracting("value").isEqualTo(-70.0);
            assertThat(vehicle.held.get("P_3")).extracting("value").isEqualTo(0.25);
        });
    }

    private static FaultCase writingOfAnAlteredParameter() {
        ParameterVehicle vehicle = ParameterVehicle.with(6, true);
        vehicle.altered = "P_1";
        return new FaultCase(
                "altered parameter",
                wire -> write(wire, vehicle),
                (wire, outcome) ->
                        assertThat(outcome).isEqualTo(new Outcome.Failed("The vehicle holds P_1 = -69, not -70.")));
    }

    private static Exchange write(TestWire wire, ParameterVehicle vehicle) {
        wire.peer(vehicle::take);
        List<ParameterValue> values = List.of(new ParameterValue("P_1", -70), new ParameterValue("P_3", 0.25));
        return new ParameterWrite(wire.target(), vehicle.codec, values, name -> null, ExchangeObserver.NONE);
    }

    private static FaultCase logListing() {
        LogVehicle vehicle = new LogVehicle(100, 4);
        List<LogListDownload> made = new ArrayList<>();
        return new FaultCase(
                "log list",
                wire -> {
                    wire.peer(vehicle::take);
                    made.add(new LogListDownload(wire.target(), ExchangeObserver.NONE));
                    return made.get(0);
                },
                (wire, outcome) -> {
                    assertThat(outcome).isEqualTo(DONE);
                    assertThat(made.get(0).logs())
                            .extracting(VehicleLog::number)
                            .containsExactly(1, 2, 3, 4);
                });
    }

    private static FaultCase logDownload() {
        LogVehicle vehicle = new LogVehicle(1_000, 4);
        LogVehicle.Memory memory = new LogVehicle.Memory();
        return new FaultCase(
                "log",
                wire -> {
                    wire.peer(vehicle::take);
                    return new LogDownload(
                            wire.target(), new VehicleLog(2, null, 1_000), memory, ExchangeObserver.NONE);
                },
                (wire, outcome) -> {
                    assertThat(outcome).isEqualTo(DONE);
                    assertThat(memory.content).isEqualTo(vehicle.content);
                });
    }
}
