package org.dronemap.proxy.mavlink.translate;

import java.util.Optional;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.drone.Severity;
import org.dronemap.mavlink.Frame;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.jspecify.annotations.Nullable;

/** Runs an exchange and adds to a refusal of the vehicle what is known of why, and what can be done instead. */
final class ExplainedExchange implements Exchange {
    private final Exchange exchange;
    private final Explanation explanation;

    /** Knowledge about a refusal besides the vehicle's own words. */
    interface Explanation {
        /** Empty where nothing is to be added to what the vehicle said. */
        Optional<Refusal> of(Refusal said);
    }

    ExplainedExchange(Exchange exchange, Explanation explanation) {
        this.exchange = exchange;
        this.explanation = explanation;
    }

    /** {@code sentence} stands after what the vehicle said itself, whatever that is. */
    ExplainedExchange(Exchange exchange, String sentence) {
        this(exchange, said -> Optional.of(after(said, said.code(), sentence)));
    }

    /** What the vehicle said, and then that sentence. */
    static Refusal after(Refusal said, OutcomeCode code, String sentence) {
        boolean whole = said.sentence().endsWith(".") || said.sentence().endsWith("!");
        return new Refusal(code, said.sentence() + (whole ? " " : ". ") + sentence);
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
        return explanation
                .of(new Refusal(refused.code(), refused.reason()))
                .<Outcome>map(why -> new Outcome.Refused(refused.by(), why))
                .orElse(refused);
    }
}
