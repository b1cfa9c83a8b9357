package org.dronemap.proxy.mavlink.translate;

import java.util.List;
import java.util.stream.IntStream;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.ExchangeSequence;
import org.dronemap.proxy.mavlink.procedure.ImmediateExchange;
import org.dronemap.proxy.mavlink.procedure.MavMissionType;
import org.dronemap.proxy.mavlink.procedure.MissionClear;
import org.dronemap.proxy.mavlink.procedure.MissionDownload;
import org.jspecify.annotations.Nullable;

/**
 * Clears a mission that a vehicle took otherwise than it was sent, or in part before it refused the rest, so that nobody
 * starts what nobody planned. What the vehicle held before, and what somebody else wrote meanwhile, is left there. Made
 * for one upload.
 */
final class MissionWithdrawal {
    private final CommandContext cockpit;
    private final int itemsBefore;
    private final @Nullable List<MissionItemInt> heldBefore;

    MissionWithdrawal(CommandContext cockpit, int itemsBefore) {
        this.cockpit = cockpit;
        this.itemsBefore = itemsBefore;
        this.heldBefore = cockpit.status().mission();
    }

    /** Ends as the upload did, and says what became of the vehicle's mission. */
    Exchange after(Outcome failed, List<MissionItem> mission) {
        MissionDownload held = MissionDownload.whole(cockpit.target(), MavMissionType.MISSION);
        MissionClear clear = new MissionClear(cockpit.target(), MavMissionType.MISSION);
        return new ExchangeSequence(List.of(
                new ExchangeSequence.Step(() -> held, any -> true),
                new ExchangeSequence.Step(
                        () -> isToGo(failed, mission, held) ? clear : new ImmediateExchange(Outcome.Succeeded::new),
                        any -> true),
                ExchangeSequence.Step.of(() -> new ImmediateExchange(() -> {
                    boolean known = isDone(held);
                    return known && !isToGo(failed, mission, held)
                            ? left(failed, held)
                            : cleared(failed, known && isDone(clear));
                }))));
    }

    private boolean isToGo(Outcome failed, List<MissionItem> mission, MissionDownload held) {
        if (!isDone(held) || held.count() <= itemsBefore || isAsBefore(held)) {
            return false;
        }
        return failed.kind() == Outcome.Kind.REFUSED || isOurs(mission, held);
    }

    private static boolean isDone(Exchange exchange) {
        return exchange.outcome() instanceof Outcome.Succeeded;
    }

    private boolean isAsBefore(MissionDownload held) {
        List<MissionItemInt> before = heldBefore;
        return before != null
                && before.size() == held.items().size()
                && IntStream.range(itemsBefore, before.size())
                        .allMatch(index -> WireMissionItems.same(
                                before.get(index), held.items().get(index)));
    }

    private boolean isOurs(List<MissionItem> mission, MissionDownload held) {
        return mission.stream()
                .map(MissionItem::kind)
                .toList()
                .equals(MissionCodec.fromWire(held.items(), itemsBefore).stream()
                        .map(MissionItem::kind)
                        .toList());
    }

    private Outcome left(Outcome failed, MissionDownload held) {
        if (failed.kind() == Outcome.Kind.REFUSED) {
            return failed;
        }
        return with(
                failed,
                held.count() <= itemsBefore
                        ? "It holds no mission now."
                        : "What it holds is not of this upload and was left there.");
    }

    private static Outcome cleared(Outcome failed, boolean done) {
        return with(
                failed,
                done
                        ? "What it had taken was cleared; it holds no mission now."
                        : "It could not be cleared; do not start the mission that the vehicle holds.");
    }

    private static Outcome with(Outcome failed, String more) {
        String sentence = failed.reason() + " " + more;
        OutcomeCode code = failed.code();
        return failed.kind() == Outcome.Kind.REFUSED && code != null
                ? new Outcome.Refused("vehicle", new Refusal(code, sentence))
                : new Outcome.Failed(sentence);
    }
}
