package org.dronemap.proxy.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.Stream;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandKind;
import org.dronemap.core.drone.Severity;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.ExchangeObserver;
import org.dronemap.proxy.mavlink.procedure.MavlinkTarget;
import org.dronemap.proxy.mavlink.translate.AutopilotAdapter;
import org.dronemap.proxy.mavlink.translate.CommandContext;
import org.dronemap.proxy.mavlink.translate.ParameterTable;
import org.dronemap.proxy.mavlink.translate.TelemetryTranslator;
import org.dronemap.proxy.mavlink.translate.VehicleStatus;

/** Every command on every autopilot while the vehicle answers nonsense: it ends, and sends no endless stream. */
final class ProcedureFuzz {
    private static final long SECOND = 1_000_000_000L;
    private static final long TICK = 20_000_000L;
    private static final long LONGEST_SILENCE = 300 * SECOND;
    private static final int MOST_SENT_PER_INPUT = 1_000;
    private static final int WARM_UP = 200;
    private static final int[] AUTOPILOTS = {3, 12, 0};
    private static final int[] TYPES = {1, 2, 10, 12, 13, 20};
    private static final List<Command> COMMANDS =
            Stream.of(CommandKind.values()).flatMap(CommandSamples::of).toList();

    private final Random random;
    private final HostileFrames hostile;
    private final String name;
    private long now = 1_000 * SECOND;
    private int rounds;

    private ProcedureFuzz(FuzzBudget budget) {
        random = budget.random();
        hostile = new HostileFrames(random, 1);
        name = budget.name();
    }

    static long run(FuzzBudget budget) {
        ProcedureFuzz fuzz = new ProcedureFuzz(budget);
        HeapGrowthCheck heap = new HeapGrowthCheck();
        while (budget.isLeft()) {
            fuzz.round();
        }
        heap.check(budget.name());
        return fuzz.rounds;
    }

    private void round() {
        rounds++;
        int type = TYPES[random.nextInt(TYPES.length)];
        Heartbeat heartbeat =
                new Heartbeat(type, AUTOPILOTS[random.nextInt(AUTOPILOTS.length)], 81, random.nextInt(30), 4, 3);
        AutopilotAdapter autopilot = AutopilotAdapter.of(heartbeat);
        Command command = COMMANDS.get(random.nextInt(COMMANDS.size()));
        if (!autopilot.capabilities().commands().contains(command.needs())) {
            return;
        }
        AtomicLong sent = new AtomicLong();
        VehicleStatus status = new VehicleStatus(type, 0);
        TelemetryTranslator telemetry = new TelemetryTranslator(autopilot, status, event -> {});
        MavlinkTarget target = new MavlinkTarget(1, 1, message -> sent.incrementAndGet());
        CommandContext cockpit = new CommandContext(
                status,
                new ParameterTable(autopilot, event -> {}),
                target,
                ExchangeObserver.NONE,
                event -> {},
                items -> {},
                sentence -> {});
        Exchange exchange = autopilot.exchangeFor(command, cockpit);
        exchange.start(now);
        for (int inputs = random.nextInt(400); inputs > 0 && exchange.outcome() == null; inputs--) {
            disturb(exchange, telemetry, sent);
        }
        endsInSilence(exchange, command);
    }

    private void disturb(Exchange exchange, TelemetryTranslator telemetry, AtomicLong sent) {
        long before = sent.get();
        byte[] bytes = hostile.next();
        List<Frame> frames = HostileFrames.parsed(bytes);
        Runnable work = () -> frames.forEach(frame -> {
            telemetry.received(frame, now);
            exchange.received(frame, now);
        });
        if (rounds < WARM_UP) {
            work.run();
        } else {
            SlowInputCheck.check(name, bytes, work);
        }
        if (random.nextInt(20) == 0) {
            exchange.textReceived(
                    Severity.values()[random.nextInt(Severity.values().length)], "PreArm: " + bytes.length, now);
        }
        for (int ticks = random.nextInt(60); ticks > 0; ticks--) {
            now += TICK;
            exchange.advance(now);
        }
        assertThat(sent.get() - before).as("sent for one input (%s)", name).isLessThan(MOST_SENT_PER_INPUT);
    }

    private void endsInSilence(Exchange exchange, Command command) {
        long deadline = now + LONGEST_SILENCE;
        while (exchange.outcome() == null && now < deadline) {
            now += 5 * TICK;
            exchange.advance(now);
        }
        assertThat(exchange.outcome()).as("%s (%s)", command.summary(), name).isNotNull();
    }
}
