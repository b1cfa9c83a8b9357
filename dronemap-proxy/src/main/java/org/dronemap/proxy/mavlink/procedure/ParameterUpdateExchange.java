package org.dronemap.proxy.mavlink.procedure;

import java.util.function.IntUnaryOperator;
import org.dronemap.core.command.Outcome;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.ParamRequestRead;
import org.dronemap.mavlink.message.ParamSet;
import org.dronemap.mavlink.message.ParamValue;
import org.jspecify.annotations.Nullable;

/** Reads one integer parameter of a vehicle, sets it to a value computed from the old one, and verifies it. */
public final class ParameterUpdateExchange implements Exchange {
    private static final int TRIES = 3;
    private static final long BETWEEN_TRIES_NANOS = 500_000_000L;
    private static final long LONGEST_NANOS = 3_000_000_000L;
    private static final int FIRST_FLOAT_TYPE = 9;

    private final MavlinkTarget target;
    private final Wanted wanted;
    private boolean setting;
    private int type;
    private int value;
    private int tries;
    private long lastSentNanos;
    private @Nullable Outcome outcome;

    /**
     * The parameter to change, its new value and its encoding.
     *
     * @param value the new value, given the old one
     * @param bytewise integers travel as their bits in the float (PX4), not as its value (ArduPilot)
     */
    public record Wanted(String name, IntUnaryOperator value, boolean bytewise) {}

    public ParameterUpdateExchange(MavlinkTarget target, Wanted wanted) {
        this.target = target;
        this.wanted = wanted;
    }

    @Override
    public void start(long nowNanos) {
        send(nowNanos);
    }

    @Override
    public void received(Frame frame, long nowNanos) {
        if (outcome != null || frame.messageId() != ParamValue.ID) {
            return;
        }
        ParamValue message = ParamValue.decode(frame);
        if (!message.paramId().equals(wanted.name())) {
            return;
        }
        type = message.paramType();
        int now = decode(message.paramValue());
        int next = wanted.value().applyAsInt(now);
        if (next == now) {
            outcome = new Outcome.Succeeded();
        } else if (decode(encode(next)) != next) {
            outcome = new Outcome.Failed(wanted.name() + " cannot be set to " + next
                    + ": on the way to this vehicle it would become " + decode(encode(next)) + ". The vehicle holds "
                    + now + "; nothing was changed.");
        } else if (!setting) {
            setting = true;
            value = next;
            tries = 0;
            send(nowNanos);
        }
    }

    @Override
    public void advance(long nowNanos) {
        if (outcome == null && nowNanos - lastSentNanos >= patienceNanos()) {
            if (tries == TRIES) {
                outcome = setting
                        ? new Outcome.Failed("The vehicle did not take " + wanted.name() + " = " + value + ".")
                        : new Outcome.TimedOut("The vehicle did not tell its parameter " + wanted.name() + ".");
            } else {
                send(nowNanos);
            }
        }
    }

    /** Before anything was measured as ground stations do it; a slow link gets its time. */
    private long patienceNanos() {
        return target.roundTrip().patienceNanos(BETWEEN_TRIES_NANOS, LONGEST_NANOS, BETWEEN_TRIES_NANOS);
    }

    private void send(long nowNanos) {
        target.send(
                setting
                        ? new ParamSet(target.systemId(), target.componentId(), wanted.name(), encode(value), type)
                        : new ParamRequestRead(target.systemId(), target.componentId(), wanted.name(), -1));
        tries++;
        lastSentNanos = nowNanos;
    }

    private boolean asBits() {
        return wanted.bytewise() && type < FIRST_FLOAT_TYPE;
    }

    private int decode(float raw) {
        return asBits() ? Float.floatToRawIntBits(raw) : Math.round(raw);
    }

    private float encode(int whole) {
        return asBits() ? Float.intBitsToFloat(whole) : whole;
    }

    @Override
    public @Nullable Outcome outcome() {
        return outcome;
    }
}
