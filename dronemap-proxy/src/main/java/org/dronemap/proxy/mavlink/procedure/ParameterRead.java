package org.dronemap.proxy.mavlink.procedure;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.ParamRequestRead;
import org.dronemap.mavlink.message.ParamValue;
import org.jspecify.annotations.Nullable;

/**
 * Reads a few parameters of a vehicle by name, all at once. A vehicle says nothing to a name that it does not know:
 * what it has not told after some tries, while it told others, it does not have.
 */
public final class ParameterRead implements Exchange {
    private static final int TRIES = 4;
    private static final long BETWEEN_TRIES_NANOS = 400_000_000L;
    private static final long LONGEST_NANOS = 3_000_000_000L;

    private final MavlinkTarget target;
    private final ParameterCodec codec;
    private final List<List<String>> wanted;
    private final Map<String, Parameter> received = new HashMap<>();
    private int tries;
    private long lastSentNanos;
    private @Nullable Outcome outcome;

    /** {@code wanted}: each by the names that firmware of different ages has for it. */
    public ParameterRead(MavlinkTarget target, ParameterCodec codec, List<List<String>> wanted) {
        this.target = target;
        this.codec = codec;
        this.wanted = List.copyOf(wanted);
    }

    /** The one that the vehicle has by one of these names. */
    public Optional<Parameter> findAny(List<String> names) {
        return names.stream().filter(received::containsKey).map(received::get).findFirst();
    }

    @Override
    public void start(long nowNanos) {
        ask(nowNanos);
    }

    private void ask(long nowNanos) {
        for (List<String> names : wanted) {
            if (findAny(names).isEmpty()) {
                names.forEach(
                        name -> target.send(new ParamRequestRead(target.systemId(), target.componentId(), name, -1)));
            }
        }
        tries++;
        lastSentNanos = nowNanos;
    }

    @Override
    public void received(Frame frame, long nowNanos) {
        if (outcome != null || frame.messageId() != ParamValue.ID) {
            return;
        }
        Parameter parameter = codec.decode(ParamValue.decode(frame));
        if (wanted.stream().anyMatch(names -> names.contains(parameter.name()))) {
            received.put(parameter.name(), parameter);
            if (wanted.stream().allMatch(names -> findAny(names).isPresent())) {
                outcome = new Outcome.Succeeded();
            }
        }
    }

    @Override
    public void advance(long nowNanos) {
        long patience = target.roundTrip().patienceNanos(BETWEEN_TRIES_NANOS, LONGEST_NANOS, BETWEEN_TRIES_NANOS);
        if (outcome != null || nowNanos - lastSentNanos < patience) {
            return;
        }
        if (tries < TRIES) {
            ask(nowNanos);
        } else {
            outcome = received.isEmpty()
                    ? new Outcome.TimedOut("The vehicle did not tell any of its parameters.")
                    : new Outcome.Succeeded();
        }
    }

    @Override
    public @Nullable Outcome outcome() {
        return outcome;
    }
}
