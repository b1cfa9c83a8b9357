package org.dronemap.proxy.mavlink.translate;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Supplier;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.mission.CountText;
import org.dronemap.core.mission.MissionComparison;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.ExchangeSequence;
import org.dronemap.proxy.mavlink.procedure.FallbackExchange;
import org.dronemap.proxy.mavlink.procedure.ImmediateExchange;
import org.dronemap.proxy.mavlink.procedure.MavMissionType;
import org.dronemap.proxy.mavlink.procedure.MissionClear;
import org.dronemap.proxy.mavlink.procedure.MissionDownload;
import org.dronemap.proxy.mavlink.procedure.MissionUpload;
import org.dronemap.proxy.mavlink.procedure.MissionUpload.Span;
import org.dronemap.proxy.mavlink.procedure.StepProgressObserver;
import org.jspecify.annotations.Nullable;

/**
 * Makes the exchanges that upload a mission to a vehicle, whole or only where it differs, verify or clear it. Made for
 * one command.
 */
final class MissionExchanges {
    private static final String ROUNDED =
            "This vehicle takes positions of missions in an old form only, exact to a metre or so.";

    private final CommandContext cockpit;
    private final int itemsBefore;
    private boolean itemsInAnyOrder;
    private @Nullable MissionUpload last;

    /** {@code itemsBefore}: how many items stand on the wire before the mission's own. */
    MissionExchanges(CommandContext cockpit, int itemsBefore) {
        this.cockpit = cockpit;
        this.itemsBefore = itemsBefore;
    }

    /** The vehicle gives items in any order. */
    MissionExchanges inAnyOrder() {
        itemsInAnyOrder = true;
        return this;
    }

    /** Writes, reads back, compares; once more when something else was found, and then takes that off the vehicle. */
    Exchange upload(List<MissionItem> mission, List<MissionItemInt> wire) {
        MissionWithdrawal withdrawal = new MissionWithdrawal(cockpit, itemsBefore);
        Supplier<Exchange> whole = () -> verified(mission, wire, new Span(0, wire.size() - 1));
        Exchange written = new FallbackExchange(whole.get(), Outcome.Failed.class::isInstance, whole);
        return new FallbackExchange(
                written,
                outcome -> isNotAccepted(outcome) && isBegun(),
                () -> withdrawal.after(Objects.requireNonNull(written.outcome()), mission));
    }

    /** A vehicle that cannot be heard is not asked to clear anything. */
    private static boolean isNotAccepted(Outcome outcome) {
        return switch (outcome.kind()) {
            case REFUSED, FAILED -> true;
            case SUCCEEDED, TIMED_OUT, SUPERSEDED, UNKNOWN -> false;
        };
    }

    /** The vehicle has begun to take what was written last. */
    private boolean isBegun() {
        MissionUpload upload = last;
        return upload != null && upload.isBegun();
    }

    /** The same, but writes only what differs when that is little; whole where the vehicle does not take that. */
    Exchange uploadInParts(List<MissionItem> mission, List<MissionItemInt> wire) {
        Optional<Span> changed = WireMissionItems.difference(cockpit.status().mission(), wire, itemsBefore)
                .filter(span -> span.size() * 2 <= wire.size() - itemsBefore);
        return changed.<Exchange>map(span -> new FallbackExchange(
                        verified(mission, wire, span),
                        outcome -> !(outcome instanceof Outcome.Succeeded),
                        () -> upload(mission, wire)))
                .orElseGet(() -> upload(mission, wire));
    }

    private Exchange verified(List<MissionItem> mission, List<MissionItemInt> wire, Span span) {
        int steps = span.size() + wire.size();
        MissionDownload readBack = MissionDownload.whole(
                cockpit.target(),
                MavMissionType.MISSION,
                new StepProgressObserver(cockpit.observer(), span.size(), steps));
        if (itemsInAnyOrder) {
            readBack.inAnyOrder();
        }
        MissionUpload upload = MissionUpload.part(
                        cockpit.target(),
                        MavMissionType.MISSION,
                        wire,
                        span,
                        new StepProgressObserver(cockpit.observer(), 0, steps))
                .withIntegerItems(cockpit.status().knowsIntegerItems());
        last = upload;
        return new ExchangeSequence(List.of(
                ExchangeSequence.Step.of(() -> upload),
                ExchangeSequence.Step.of(() -> readBack),
                ExchangeSequence.Step.of(() -> new ImmediateExchange(() -> compare(mission, upload, readBack)))));
    }

    private Outcome compare(List<MissionItem> mission, MissionUpload upload, MissionDownload readBack) {
        List<MissionItem> found = MissionCodec.fromWire(readBack.items(), itemsBefore);
        List<MissionItem> wanted = mission;
        if (upload.isRounded()) {
            cockpit.warning().accept(ROUNDED);
            wanted = MissionCodec.fromWire(upload.acceptedItems(), itemsBefore);
        }
        return MissionComparison.difference(wanted, found)
                .<Outcome>map(difference ->
                        new Outcome.Failed("The vehicle holds another mission than the one sent: " + difference + "."))
                .orElseGet(() -> {
                    cockpit.missionRead().accept(readBack);
                    return new Outcome.Succeeded();
                });
    }

    Exchange clear() {
        MissionDownload readBack = MissionDownload.whole(cockpit.target(), MavMissionType.MISSION);
        return new ExchangeSequence(List.of(
                ExchangeSequence.Step.of(() -> new MissionClear(cockpit.target(), MavMissionType.MISSION)),
                ExchangeSequence.Step.of(() -> readBack),
                ExchangeSequence.Step.of(() -> new ImmediateExchange(() -> {
                    if (readBack.count() > itemsBefore) {
                        return new Outcome.Failed("The vehicle still has "
                                + CountText.of(readBack.count() - itemsBefore, "mission item") + ".");
                    }
                    cockpit.missionRead().accept(readBack);
                    return new Outcome.Succeeded();
                }))));
    }
}
