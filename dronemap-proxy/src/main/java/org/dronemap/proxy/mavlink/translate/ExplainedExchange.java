package org.dronemap.proxy.mavlink.translate;

import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.drone.Severity;
import org.dronemap.mavlink.Frame;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.jspecify.annotations.Nullable;

/** Runs an exchange and adds to a refusal of the vehicle what is known of why, and what can be done instead. */
final class ExplainedExchange implements Exchange {
    private final Exchange exchange;
    private final String sentence;

    /** {@code sentence} stands after what the vehicle said itself. */
    ExplainedExchange(Exchange exchange, String sentence) {
        this.exchange = exchange;
        this.sentence = sentence;
    }

    @Override
    public void start(long nowNanos) {
        exchange.start(nowNanos);
    }

    @Override
    public void received(Frame frame, long nowNanos) {
        exchange.received(frame, nowNanos);
    }

    @Override
    public void textReceived(Severity severity, String text, long nowNanos) {
        exchange.textReceived(severity, text, nowNanos);
    }

    @Override
    public void advance(long nowNanos) {
        exchange.advance(nowNanos);
    }

    @Override
    public void cancel(long nowNanos) {
        exchange.cancel(nowNanos);
    }

    @Override
    public @Nullable Outcome outcome() {
        Outcome outcome = exchange.outcome();
        if (!(outcome instanceof Outcome.Refused refused) || !refused.by().equals("vehicle")) {
            return outcome;
        }
        String said = refused.reason();
        String end = said.endsWith(".") || said.endsWith("!") ? " " : ". ";
        return new Outcome.Refused(refused.by(), new Refusal(refused.code(), said + end + sentence));
    }
}
