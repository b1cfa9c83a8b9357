package org.dronemap.proxy.mavlink.procedure;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.ParamRequestList;
import org.dronemap.mavlink.message.ParamRequestRead;
import org.dronemap.mavlink.message.ParamValue;
import org.jspecify.annotations.Nullable;

/**
 * Downloads all parameters of a vehicle: requests the list, then each one that is missing. What a vehicle that is heard
 * does not tell is left out, and named.
 */
public final class ParameterDownload implements Exchange {
    static final int MOST_PARAMETERS = 10_000;
    private static final long IDLE_NANOS = 1_000_000_000L;
    private static final int IN_FLIGHT = 16;
    /** A vehicle that is heard and tells none of those that are missing for so long does not tell them. */
    private static final long NOTHING_NEW_NANOS = 20_000_000_000L;

    private static final int MOST_NAMED = 3;
    /** A vehicle that counts anew with every message would never be through. */
    private static final int MOST_RECOUNTS = 3;
    /** As in answers to a write; some vehicles number nothing. */
    private static final int NO_INDEX = 65_535;

    private final MavlinkTarget target;
    private final ParameterCodec codec;
    private final ExchangeObserver observer;
    private final SortedMap<Integer, Parameter> byIndex = new TreeMap<>();
    private final SortedSet<Integer> untold = new TreeSet<>();
    private RequestWindow<Integer> gaps;
    private RetrySchedule pace = new RetrySchedule(0, 0, 0);
    /** Of those with the number of another one, or without one. By name. */
    private final SortedMap<String, Parameter> beside = new TreeMap<>();

    private int count = -1;
    private int recounts;
    private final TransferTimeout patience = new TransferTimeout();
    private int tries;
    private long lastSentNanos;
    private @Nullable Outcome outcome;

    public ParameterDownload(MavlinkTarget target, ParameterCodec codec, ExchangeObserver observer) {
        this.target = target;
        this.codec = codec;
        this.observer = observer;
        this.gaps = new RequestWindow<>(0, pace, index -> {});
    }

    /** What was read, in the order of the vehicle; of two with one name the later one. */
    public List<Parameter> parameters() {
        Map<String, Parameter> all = new LinkedHashMap<>();
        byIndex.values().forEach(parameter -> all.put(parameter.name(), parameter));
        beside.forEach(all::putIfAbsent);
        return List.copyOf(all.values());
    }

    /** Which ones the vehicle did not tell, or cannot be told apart, as sentences; empty when it told all. */
    public Optional<String> incomplete() {
        int read = parameters().size();
        if (count < 0 || read >= count) {
            return Optional.empty();
        }
        List<Integer> missing = missing();
        return Optional.of(missing.isEmpty() ? sameNames(read) : untold(read, missing));
    }

    private String sameNames(int read) {
        Set<String> names = new HashSet<>();
        List<String> twice = byIndex.values().stream()
                .map(Parameter::name)
                .filter(name -> !names.add(name))
                .distinct()
                .toList();
        int more = twice.size() - MOST_NAMED;
        return read + " of " + count + " parameters were read and can be used. The vehicle has several that are called "
                + String.join(", ", twice.subList(0, Math.min(MOST_NAMED, twice.size())))
                + (more > 0 ? " and " + more + " more such names" : "")
                + "; only the last one of each is shown, since they cannot be told apart.";
    }

    private String untold(int read, List<Integer> missing) {
        List<String> named = missing.stream()
                .limit(MOST_NAMED)
                .map(index -> index + place(index))
                .toList();
        int more = missing.size() - named.size();
        return read + " of " + count
                + " parameters were read and can be used. The vehicle did not tell number " + String.join(", ", named)
                + (more > 0 ? " and " + more + " more" : "") + ", counted from 0, though it was asked for "
                + (missing.size() == 1 ? "it" : "them") + " again and again.";
    }

    /** Between which names it would stand: its own is not known. */
    private String place(int index) {
        Parameter before = byIndex.get(index - 1);
        Parameter after = byIndex.get(index + 1);
        if (before != null) {
            return " (after " + before.name() + ")";
        }
        return after == null ? "" : " (before " + after.name() + ")";
    }

    @Override
    public void start(long nowNanos) {
        pace = RetrySchedule.of(target.roundTrip(), 0);
        gaps = new RequestWindow<>(IN_FLIGHT, pace, this::askFor);
        patience.begin(nowNanos);
        ask(nowNanos);
    }

    private void ask(long nowNanos) {
        target.send(new ParamRequestList(target.systemId(), target.componentId()));
        patience.asked(nowNanos);
        tries++;
        lastSentNanos = nowNanos;
    }

    private void askFor(int index) {
        target.send(new ParamRequestRead(target.systemId(), target.componentId(), "", index));
    }

    @Override
    public void received(Frame frame, long nowNanos) {
        if (outcome != null) {
            return;
        }
        patience.received(nowNanos);
        if (frame.messageId() == ParamValue.ID) {
            valueReceived(ParamValue.decode(frame), nowNanos);
        }
    }

    /** Answers to a write carry no index; they are no part of the list. */
    private void valueReceived(ParamValue message, long nowNanos) {
        int index = message.paramIndex();
        if (index == NO_INDEX && count < 0 && !message.paramId().isEmpty()) {
            unnumbered(message, nowNanos);
            return;
        }
        if (index >= message.paramCount() || message.paramId().isEmpty()) {
            return;
        }
        if (message.paramCount() > MOST_PARAMETERS) {
            outcome = new Outcome.Failed("The vehicle says it has " + message.paramCount() + " parameters.");
            return;
        }
        if (message.paramCount() != count) {
            counted(message.paramCount());
        }
        numbered(index, codec.decode(message), nowNanos);
    }

    private void numbered(int index, Parameter parameter, long nowNanos) {
        gaps.answered(index);
        untold.remove(index);
        Parameter before = byIndex.put(index, parameter);
        if (before != null && !before.name().equals(parameter.name())) {
            beside.put(before.name(), before);
        }
        if (before == null) {
            patience.progressed(nowNanos);
            observer.progress(byIndex.size(), count);
        }
        if (byIndex.size() == count || (!beside.isEmpty() && parameters().size() >= count)) {
            outcome = new Outcome.Succeeded();
        }
    }

    /** One more or less in the middle gives all that follow other numbers: those that are held are read again. */
    private void counted(int now) {
        if (count < 0) {
            beside.clear();
        } else if (recounts < MOST_RECOUNTS) {
            recounts++;
            byIndex.clear();
            untold.clear();
            beside.clear();
        }
        count = now;
        byIndex.tailMap(count).clear();
        untold.tailSet(count).clear();
    }

    /** Of a vehicle that has numbered nothing yet; when it is through is known by the count alone. */
    private void unnumbered(ParamValue message, long nowNanos) {
        Parameter parameter = codec.decode(message);
        if (beside.size() < MOST_PARAMETERS && beside.put(parameter.name(), parameter) == null) {
            patience.progressed(nowNanos);
        }
        if (message.paramCount() > 1 && beside.size() == message.paramCount()) {
            outcome = new Outcome.Succeeded();
        }
    }

    @Override
    public void advance(long nowNanos) {
        if (outcome != null) {
            return;
        }
        if (patience.isBrokenOff(nowNanos)) {
            outcome = new Outcome.TimedOut("Nothing more came within 60 s; " + byIndex.size() + " of "
                    + Math.max(count, 0) + " parameters were read.");
        } else if (count < 0) {
            askAgain(nowNanos);
        } else {
            if (gaps.isEmpty() && patience.sinceNewsNanos(nowNanos) >= Math.max(IDLE_NANOS, pace.firstNanos())) {
                gaps.add(missing());
            }
            gaps.sendDue(nowNanos, patience.isAudible(nowNanos));
            if (patience.isAudible(nowNanos)) {
                giveUpUntold(nowNanos);
            }
        }
    }

    /** As long as at least half is there: with less it is no list. */
    private void giveUpUntold(long nowNanos) {
        for (int index : gaps.askedInVain(TransferTimeout.TRIES + 1)) {
            gaps.answered(index);
            untold.add(index);
        }
        boolean allAsked = untold.size() + byIndex.size() == count;
        if ((allAsked || patience.sinceNewsNanos(nowNanos) >= NOTHING_NEW_NANOS) && 2 * byIndex.size() >= count) {
            outcome = new Outcome.Succeeded();
        }
    }

    private void askAgain(long nowNanos) {
        if (nowNanos - lastSentNanos < Math.max(IDLE_NANOS, pace.pauseNanos(tries))) {
            return;
        }
        outcome = patience.end(nowNanos);
        if (outcome == null) {
            ask(nowNanos);
        } else if (!beside.isEmpty()) {
            outcome = new Outcome.TimedOut("The vehicle tells parameters without their numbers; " + beside.size()
                    + " different ones came, and nobody can know whether these are all.");
        }
    }

    private List<Integer> missing() {
        List<Integer> missing = new ArrayList<>();
        for (int index = 0; index < count; index++) {
            if (!byIndex.containsKey(index) && (outcome != null || !untold.contains(index))) {
                missing.add(index);
            }
        }
        return missing;
    }

    @Override
    public @Nullable Outcome outcome() {
        return outcome;
    }
}
