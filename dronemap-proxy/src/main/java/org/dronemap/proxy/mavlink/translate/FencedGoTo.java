package org.dronemap.proxy.mavlink.translate;

import java.util.List;
import java.util.Optional;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.mavlink.Frame;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.ParameterRead;
import org.jspecify.annotations.Nullable;

/**
 * Sends an ArduPilot vehicle to a place, and looks at its own fence when it refuses: it gives no reason where a place
 * is outside of that.
 */
final class FencedGoTo implements Exchange {
    private final CommandContext cockpit;
    private final Command.GoTo command;
    private final Exchange goTo;
    private @Nullable ParameterRead fence;
    private Outcome.@Nullable Refused refused;
    private @Nullable Outcome outcome;

    FencedGoTo(CommandContext cockpit, Command.GoTo command, Exchange goTo) {
        this.cockpit = cockpit;
        this.command = command;
        this.goTo = goTo;
    }

    @Override
    public void start(long nowNanos) {
        goTo.start(nowNanos);
        look(nowNanos);
    }

    @Override
    public void received(Frame frame, long nowNanos) {
        current().received(frame, nowNanos);
        look(nowNanos);
    }

    @Override
    public void textReceived(Severity severity, String text, long nowNanos) {
        current().textReceived(severity, text, nowNanos);
    }

    @Override
    public void advance(long nowNanos) {
        current().advance(nowNanos);
        look(nowNanos);
    }

    @Override
    public void cancel(long nowNanos) {
        current().cancel(nowNanos);
    }

    @Override
    public @Nullable Outcome outcome() {
        return outcome;
    }

    private Exchange current() {
        ParameterRead reading = fence;
        return reading == null ? goTo : reading;
    }

    private void look(long nowNanos) {
        Outcome ended = current().outcome();
        if (outcome != null || ended == null) {
            return;
        }
        Outcome.Refused no = refused;
        ParameterRead read = fence;
        if (no != null && read != null) {
            outcome = explained(no, read);
        } else if (ended instanceof Outcome.Refused now && now.by().equals("vehicle")) {
            refused = now;
            ParameterRead next =
                    new ParameterRead(cockpit.target(), cockpit.parameters().codec(), FenceParameters.names());
            fence = next;
            next.start(nowNanos);
            look(nowNanos);
        } else {
            outcome = ended;
        }
    }

    private Outcome explained(Outcome.Refused no, ParameterRead read) {
        return new FenceParameters(name -> read.findAny(List.of(name)).map(Parameter::value))
                .against(cockpit.status(), command)
                .<Outcome>map(why -> new Outcome.Refused(
                        no.by(),
                        ExplainedExchange.after(new Refusal(no.code(), no.reason()), OutcomeCode.FENCE_FORBIDS, why)))
                .orElse(no);
    }

    /** {@code value}: of the parameter with that name, where the vehicle has it. */
    interface Values {
        Optional<Double> of(String name);
    }
}
