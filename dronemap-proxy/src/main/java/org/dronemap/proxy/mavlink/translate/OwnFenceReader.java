package org.dronemap.proxy.mavlink.translate;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.OnboardFence;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.ExchangeSequence;
import org.dronemap.proxy.mavlink.procedure.ImmediateExchange;
import org.dronemap.proxy.mavlink.procedure.MavMissionType;
import org.dronemap.proxy.mavlink.procedure.MissionDownload;
import org.dronemap.proxy.mavlink.procedure.ParameterRead;
import org.jspecify.annotations.Nullable;

/**
 * Reads the fence of an ArduPilot vehicle, only as much of it as is on: one question where none is. Used once; nothing
 * that goes wrong ends the command that it is read for.
 */
final class OwnFenceReader {
    /** More take too long to read before a flight. */
    private static final int MOST_POINTS = 100;

    private final CommandContext cockpit;
    private final List<ParameterRead> reads = new ArrayList<>();
    private @Nullable MissionDownload points;

    OwnFenceReader(CommandContext cockpit) {
        this.cockpit = cockpit;
    }

    List<ExchangeSequence.Step> steps() {
        return List.of(
                new ExchangeSequence.Step(() -> read(Stream.of(OwnFence.ENABLE, OwnFence.TYPE)), any -> true),
                new ExchangeSequence.Step(this::readBounds, any -> true),
                new ExchangeSequence.Step(this::readAreas, any -> true));
    }

    OwnFence fence() {
        MissionDownload read = points;
        OnboardFence areas = read != null && read.outcome() instanceof Outcome.Succeeded
                ? FenceCodec.fenceFromWire(read.items())
                : null;
        return new OwnFence(this::value, areas);
    }

    private Optional<Double> value(String name) {
        return reads.stream()
                .flatMap(read -> read.findAny(List.of(name)).stream())
                .findFirst()
                .map(Parameter::value);
    }

    private Exchange read(Stream<String> names) {
        ParameterRead read = new ParameterRead(
                cockpit.target(),
                cockpit.parameters().codec(),
                names.map(List::of).toList());
        reads.add(read);
        return read;
    }

    private Exchange readBounds() {
        int type = value(OwnFence.TYPE).map(Double::intValue).orElse(0);
        List<String> names = new ArrayList<>();
        addIf(names, type & OwnFence.BY_HEIGHT, OwnFence.HIGHEST);
        addIf(names, type & OwnFence.BY_CIRCLE, OwnFence.RADIUS);
        addIf(names, type & OwnFence.BY_AREAS, OwnFence.TOTAL, OwnFence.OPTIONS);
        addIf(names, type & OwnFence.BY_FLOOR, OwnFence.LOWEST);
        return fence().isOn() && !names.isEmpty() ? read(names.stream()) : nothing();
    }

    private static void addIf(List<String> names, int bit, String... more) {
        if (bit != 0) {
            names.addAll(List.of(more));
        }
    }

    private Exchange readAreas() {
        if (!fence().mayHaveAreas() || value(OwnFence.TOTAL).orElse(MOST_POINTS + 1.0) > MOST_POINTS) {
            return nothing();
        }
        MissionDownload download = MissionDownload.whole(cockpit.target(), MavMissionType.FENCE);
        points = download;
        return download;
    }

    private static Exchange nothing() {
        return new ImmediateExchange(Outcome.Succeeded::new);
    }
}
