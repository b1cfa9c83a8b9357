package org.dronemap.proxy.mavlink.procedure;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.core.parameter.ParameterValue;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.ParamRequestRead;
import org.dronemap.mavlink.message.ParamSet;
import org.dronemap.mavlink.message.ParamValue;
import org.jspecify.annotations.Nullable;

/**
 * Writes parameters to a vehicle and reads each one back, with retries until all are as wanted. Goes on after a break
 * of the link.
 */
public final class ParameterWrite implements Exchange {
    private static final int IN_FLIGHT = 16;
    private static final int ROUNDS = 3;
    private static final int MOST_NAMED = 3;

    private enum Phase {
        LEARN,
        SET,
        SETTLE,
        CHECK
    }

    private final MavlinkTarget target;
    private final ParameterCodec codec;
    private final ExchangeObserver observer;
    private final Map<String, ParameterValue> wanted = new LinkedHashMap<>();
    private final Map<String, Parameter> held = new HashMap<>();
    private final List<String> wrong = new ArrayList<>();
    private final Function<String, @Nullable Parameter> known;
    private Phase phase = Phase.LEARN;
    private RequestWindow<String> open;
    private int round = 1;
    private int steps;
    private int reportedCount = -1;
    private long phaseNanos;
    private final TransferTimeout patience = new TransferTimeout();
    private @Nullable Outcome outcome;

    /** {@code known}: what the vehicle said before of a parameter, for its type; null when it did not. */
    public ParameterWrite(
            MavlinkTarget target,
            ParameterCodec codec,
            List<ParameterValue> values,
            Function<String, @Nullable Parameter> known,
            ExchangeObserver observer) {
        this.target = target;
        this.codec = codec;
        this.known = known;
        this.observer = observer;
        values.forEach(value -> wanted.put(value.name(), value));
        this.open = new RequestWindow<>(0, new RetrySchedule(0, 0, 0), name -> {});
    }

    @Override
    public void start(long nowNanos) {
        patience.begin(nowNanos);
        List<String> unknown = new ArrayList<>();
        for (String name : wanted.keySet()) {
            Parameter before = known.apply(name);
            if (before == null) {
                unknown.add(name);
            } else {
                held.put(name, before);
            }
        }
        enter(Phase.LEARN, unknown, this::read, nowNanos);
        advance(nowNanos);
    }

    private void enter(Phase next, List<String> names, java.util.function.Consumer<String> ask, long nowNanos) {
        phase = next;
        phaseNanos = nowNanos;
        open = new RequestWindow<>(IN_FLIGHT, RetrySchedule.of(target.roundTrip(), 0), ask);
        open.add(names);
    }

    private void read(String name) {
        target.send(new ParamRequestRead(target.systemId(), target.componentId(), name, -1));
    }

    private void set(String name) {
        Parameter before = held.get(name);
        ParameterValue value = wanted.get(name);
        if (before != null && value != null) {
            target.send(new ParamSet(
                    target.systemId(),
                    target.componentId(),
                    name,
                    codec.encode(before.type(), before.type().held(value.value())),
                    ParameterCodec.number(before.type())));
        }
    }

    @Override
    public void received(Frame frame, long nowNanos) {
        if (outcome != null) {
            return;
        }
        patience.received(nowNanos);
        if (frame.messageId() == ParamValue.ID) {
            Parameter parameter = codec.decode(ParamValue.decode(frame));
            if (open.isAsked(parameter.name()) && counts(parameter)) {
                open.answered(parameter.name());
                held.put(parameter.name(), parameter);
                patience.progressed(nowNanos);
                answered(parameter);
            }
        }
    }

    /** What a vehicle held before may still be on its way while it is set: only the new value is an answer to that. */
    private boolean counts(Parameter parameter) {
        return phase != Phase.SET || isRight(parameter) || open.askedInVain(2).contains(parameter.name());
    }

    private boolean isRight(Parameter parameter) {
        ParameterValue value = wanted.get(parameter.name());
        return value != null && codec.afterWire(parameter.type(), value.value()) == parameter.value();
    }

    private void answered(Parameter parameter) {
        if (phase == Phase.CHECK && !isRight(parameter)) {
            wrong.add(parameter.name());
        } else if (phase != Phase.LEARN) {
            steps++;
            reportProgress();
        }
    }

    private void reportProgress() {
        int done = Math.min(wanted.size(), steps / 2);
        if (done > reportedCount) {
            reportedCount = done;
            observer.progress(done, wanted.size());
        }
    }

    @Override
    public void advance(long nowNanos) {
        if (outcome != null) {
            return;
        }
        open.sendDue(nowNanos, patience.isAudible(nowNanos));
        if (open.isEmpty()) {
            enterNextPhase(nowNanos);
        } else if (patience.isBrokenOff(nowNanos)) {
            outcome = unanswered("within 60 s");
        } else if (patience.isAudible(nowNanos)
                && !open.askedInVain(TransferTimeout.TRIES + 1).isEmpty()) {
            outcome = unanswered("after " + TransferTimeout.TRIES + " tries");
        }
    }

    private Outcome unanswered(String when) {
        Set<String> vain = open.askedInVain(2);
        String which = vain.stream().min(Comparator.naturalOrder()).orElse("a parameter");
        return switch (phase) {
            case LEARN ->
                new Outcome.TimedOut("The vehicle did not tell its parameter " + which + " " + when
                        + "; it may not have it. Nothing was changed.");
            case SET, SETTLE ->
                new Outcome.Unknown(
                        "The vehicle did not answer to " + which + " " + when + "; whether it took it is not known.");
            case CHECK -> new Outcome.Unknown(which + " was set, but the vehicle did not tell it again " + when + ".");
        };
    }

    private void enterNextPhase(long nowNanos) {
        switch (phase) {
            case LEARN -> {
                outcome = unfit();
                if (outcome == null) {
                    enter(Phase.SET, List.copyOf(wanted.keySet()), this::set, nowNanos);
                }
            }
            case SET -> enter(Phase.SETTLE, List.of(), name -> {}, nowNanos);
            case SETTLE -> {
                // So long an echo of the writing may still be under way; it must not pass for a reading.
                if (nowNanos - phaseNanos >= target.roundTrip().timeoutNanos()) {
                    List<String> toCheck = round == 1 ? List.copyOf(wanted.keySet()) : List.copyOf(wrong);
                    wrong.clear();
                    enter(Phase.CHECK, toCheck, this::read, nowNanos);
                }
            }
            case CHECK -> conclude(nowNanos);
        }
    }

    /** What would come out as another whole number on the wire is not sent; null when all can be. */
    private @Nullable Outcome unfit() {
        for (ParameterValue value : wanted.values()) {
            Parameter now = held.get(value.name());
            if (now == null || now.type().decimal()) {
                continue;
            }
            double meant = now.type().held(value.value());
            double told = codec.afterWire(now.type(), meant);
            if (told != meant) {
                return new Outcome.Failed(now.withValue(meant).name() + " cannot be set to "
                        + now.withValue(meant).text() + ": on the way to this vehicle it would become "
                        + now.withValue(told).text() + ". The vehicle holds " + now.name() + " = " + now.text()
                        + "; nothing was changed.");
            }
        }
        return null;
    }

    private void conclude(long nowNanos) {
        if (wrong.isEmpty()) {
            observer.progress(wanted.size(), wanted.size());
            outcome = new Outcome.Succeeded();
        } else if (round < ROUNDS) {
            round++;
            enter(Phase.SET, List.copyOf(wrong), this::set, nowNanos);
        } else {
            outcome = new Outcome.Failed(sentence());
        }
    }

    private String sentence() {
        List<String> parts = new ArrayList<>();
        for (String name : wrong.subList(0, Math.min(MOST_NAMED, wrong.size()))) {
            Parameter now = held.get(name);
            ParameterValue value = wanted.get(name);
            if (now != null && value != null) {
                parts.add(name + " = " + now.text() + ", not "
                        + now.withValue(now.type().held(value.value())).text());
            }
        }
        int more = wrong.size() - parts.size();
        return "The vehicle holds " + String.join("; ", parts) + (more > 0 ? "; and " + more + " more" : "") + ".";
    }

    @Override
    public @Nullable Outcome outcome() {
        return outcome;
    }
}
