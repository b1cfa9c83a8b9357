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
    private record Conversation(
            String name, Function<Wire, Exchange> begin, BiConsumer<Wire, @Nullable Outcome> judge) {}

    @TestFactory
    Stream<DynamicTest> comesToTheRightEnd() {
        return Stream.<Supplier<Conversation>>of(
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

    private static Stream<DynamicTest> everyFaultOf(Supplier<Conversation> conversation) {
        int messages = run(conversation.get(), wire -> {}).crossed();
        assertThat(messages).as("messages of " + conversation.get().name()).isGreaterThan(1);
        return Stream.of(Fault.values())
                .flatMap(fault -> IntStream.range(0, messages)
                        .mapToObj(number -> DynamicTest.dynamicTest(
                                conversation.get().name() + ", message " + number + " " + fault,
                                () -> run(conversation.get(), wire -> wire.fault(fault, number)))));
    }

    private static Wire run(Conversation conversation, java.util.function.Consumer<Wire> prepare) {
        Wire wire = new Wire();
        prepare.accept(wire);
        Exchange exchange = conversation.begin().apply(wire);
        Outcome outcome = wire.runWhole(exchange);
        conversation.judge().accept(wire, outcome);
        return wire;
    }

    private static Conversation repeatableCommand() {
        AtomicInteger acted = new AtomicInteger();
        return new Conversation("repeatable command", wire -> command(wire, acted, false), (wire, outcome) -> {
            assertThat(outcome).isEqualTo(DONE);
            assertThat(acted).hasPositiveValue();
        });
    }

    private static Conversation onceOnlyCommand() {
        AtomicInteger acted = new AtomicInteger();
        return new Conversation("once-only command", wire -> command(wire, acted, true), (wire, outcome) -> {
            assertThat(wire.sent()).hasSize(1);
            if (outcome instanceof Outcome.Succeeded) {
                assertThat(acted).hasPositiveValue();
            } else {
                assertThat(outcome).isInstanceOf(Outcome.Unknown.class);
            }
        });
    }

    private static Exchange command(Wire wire, AtomicInteger acted, boolean once) {
        wire.peer((w, message) -> {
            acted.incrementAndGet();
            w.answer(new CommandAck(COMMAND, 0, 0, 0, 255, 190));
        });
        CommandRequest request = CommandRequest.ofLong(
                wire.target(),
                COMMAND,
                new float[] {1f},
                once ? CommandRequest.Retry.ONCE : CommandRequest.Retry.REPEATABLE,
                CommandRequest.Proof.ACKNOWLEDGED);
        return new CommandExchange(wire.target(), request, Observer.NONE);
    }

    private static List<MissionItemInt> items() {
        return IntStream.range(0, 5)
                .mapToObj(seq -> new MissionItemInt(1, 1, seq, 3, 16, 0, 1, 0f, 0f, 0f, 0f, 10 + seq, 20, 30f, 0))
                .toList();
    }

    private static Conversation upload() {
        MissionVehicle vehicle = new MissionVehicle();
        return new Conversation(
                "mission upload",
                wire -> {
                    wire.peer(vehicle::take);
                    return new MissionUpload(wire.target(), MissionKind.MISSION, items(), Observer.NONE);
                },
                (wire, outcome) -> {
                    assertThat(outcome).isEqualTo(DONE);
                    assertThat(vehicle.held).isEqualTo(items());
                });
    }

    private static Conversation partialUpload() {
        MissionVehicle vehicle = new MissionVehicle();
        vehicle.held = new ArrayList<>(otherItems());
        return new Conversation(
                "partial mission upload",
                wire -> {
                    wire.peer(vehicle::take);
                    return MissionUpload.part(
                            wire.target(), MissionKind.MISSION, items(), new MissionUpload.Span(1, 2), Observer.NONE);
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

    private static Conversation homeReading() {
        return new Conversation(
                "home reading",
                wire -> {
                    wire.peer((w, message) ->
                            w.answer(new HomePosition(10, 20, 30_000, 0f, 0f, 0f, new float[4], 0f, 0f, 0f, 0L)));
                    return new HomeReading(wire.target(), home -> home.latitude() == 10, home -> "elsewhere");
                },
                (wire, outcome) -> assertThat(outcome).isEqualTo(DONE));
    }

    private static Conversation download(boolean inAnyOrder) {
        MissionVehicle vehicle = new MissionVehicle();
        vehicle.held = new ArrayList<>(items());
        List<MissionDownload> made = new ArrayList<>();
        return new Conversation(
                inAnyOrder ? "mission download in any order" : "mission download",
                wire -> {
                    wire.peer(vehicle::take);
                    made.add(MissionDownload.whole(wire.target(), MissionKind.MISSION));
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

    private static Conversation clear() {
        MissionVehicle vehicle = new MissionVehicle();
        vehicle.held = new ArrayList<>(items());
        return new Conversation(
                "mission clear",
                wire -> {
                    wire.peer(vehicle::take);
                    return new MissionClear(wire.target(), MissionKind.MISSION);
                },
                (wire, outcome) -> {
                    assertThat(outcome).isEqualTo(DONE);
                    assertThat(vehicle.held).isEmpty();
                });
    }

    private static Conversation listing() {
        ParameterVehicle vehicle = ParameterVehicle.with(20, false);
        List<ParameterListing> made = new ArrayList<>();
        return new Conversation(
                "parameter list",
                wire -> {
                    wire.peer(vehicle::take);
                    made.add(new ParameterListing(wire.target(), vehicle.codec, Observer.NONE));
                    return made.get(0);
                },
                (wire, outcome) -> {
                    assertThat(outcome).isEqualTo(DONE);
                    assertThat(made.get(0).parameters()).containsExactlyElementsOf(vehicle.held.values());
                });
    }

    private static Conversation writing() {
        ParameterVehicle vehicle = ParameterVehicle.with(6, true);
        return new Conversation("parameter change", wire -> write(wire, vehicle), (wire, outcome) -> {
            assertThat(outcome).isEqualTo(DONE);
            assertThat(vehicle.held.get("P_1")).extracting("value").isEqualTo(-70.0);
            assertThat(vehicle.held.get("P_3")).extracting("value").isEqualTo(0.25);
        });
    }

    private static Conversation writingOfAnAlteredParameter() {
        ParameterVehicle vehicle = ParameterVehicle.with(6, true);
        vehicle.altered = "P_1";
        return new Conversation(
                "altered parameter",
                wire -> write(wire, vehicle),
                (wire, outcome) ->
                        assertThat(outcome).isEqualTo(new Outcome.Failed("The vehicle holds P_1 = -69, not -70.")));
    }

    private static Exchange write(Wire wire, ParameterVehicle vehicle) {
        wire.peer(vehicle::take);
        List<ParameterValue> values = List.of(new ParameterValue("P_1", -70), new ParameterValue("P_3", 0.25));
        return new ParameterWriting(wire.target(), vehicle.codec, values, name -> null, Observer.NONE);
    }

    private static Conversation logListing() {
        LogVehicle vehicle = new LogVehicle(100, 4);
        List<LogListing> made = new ArrayList<>();
        return new Conversation(
                "log list",
                wire -> {
                    wire.peer(vehicle::take);
                    made.add(new LogListing(wire.target(), Observer.NONE));
                    return made.get(0);
                },
                (wire, outcome) -> {
                    assertThat(outcome).isEqualTo(DONE);
                    assertThat(made.get(0).logs())
                            .extracting(VehicleLog::number)
                            .containsExactly(1, 2, 3, 4);
                });
    }

    private static Conversation logDownload() {
        LogVehicle vehicle = new LogVehicle(1_000, 4);
        LogVehicle.Memory memory = new LogVehicle.Memory();
        return new Conversation(
                "log",
                wire -> {
                    wire.peer(vehicle::take);
                    return new LogDownload(wire.target(), new VehicleLog(2, null, 1_000), memory, Observer.NONE);
                },
                (wire, outcome) -> {
                    assertThat(outcome).isEqualTo(DONE);
                    assertThat(memory.content).isEqualTo(vehicle.content);
                });
    }
}
