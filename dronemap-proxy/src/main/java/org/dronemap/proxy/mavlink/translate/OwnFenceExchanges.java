package org.dronemap.proxy.mavlink.translate;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.ExchangeSequence;
import org.dronemap.proxy.mavlink.procedure.FallbackExchange;
import org.dronemap.proxy.mavlink.procedure.ImmediateExchange;
import org.jspecify.annotations.Nullable;

/**
 * Makes the exchanges that compare where an ArduPilot vehicle is sent with its own fence: it refuses a place outside
 * without a reason, and flies a mission up to its fence, to break it off there.
 */
final class OwnFenceExchanges {
    /** Items that it goes to: waypoint, circles, landings, spline. */
    private static final Set<Integer> PLACES = Set.of(16, 17, 18, 19, 21, 31, 82, 84, 85);

    private static final Set<Integer> UP_OR_DOWN =
            Set.of(MissionCodec.NAV_TAKEOFF, MissionCodec.NAV_LAND, 84, MissionCodec.NAV_VTOL_LAND);
    private static final double E7 = 1e7;

    private OwnFenceExchanges() {}

    /** Sends it to a place by {@code goTo}, and reads its fence when it refuses that. */
    static Exchange goTo(CommandContext cockpit, Command.GoTo command, Exchange goTo) {
        return new FallbackExchange(
                goTo,
                ended ->
                        ended instanceof Outcome.Refused refused && refused.by().equals("vehicle"),
                () -> {
                    OwnFenceReader reader = new OwnFenceReader(cockpit);
                    List<ExchangeSequence.Step> steps = new ArrayList<>(reader.steps());
                    steps.add(ExchangeSequence.Step.of(() -> new ImmediateExchange(() -> explained(
                            (Outcome.Refused) Objects.requireNonNull(goTo.outcome()),
                            cockpit,
                            command,
                            reader.fence()))));
                    return new ExchangeSequence(steps);
                });
    }

    private static Outcome explained(
            Outcome.Refused refused, CommandContext cockpit, Command.GoTo command, OwnFence fence) {
        VehicleStatus status = cockpit.status();
        OwnFence.Target target = new OwnFence.Target(
                "The place", status.point(), command.point(), aboveHome(status, command.altitude()), false);
        return fence.against(status, target)
                .or(() -> fence.hasUnreadAreas()
                        ? Optional.of("Its own fence has areas that were not compared with the place, which may lie"
                                + " outside of them; read its fence.")
                        : Optional.empty())
                .<Outcome>map(why -> new Outcome.Refused(
                        refused.by(),
                        ExplainedExchange.after(
                                new Refusal(refused.code(), refused.reason()), OutcomeCode.FENCE_FORBIDS, why)))
                .orElse(refused);
    }

    private static @Nullable Double aboveHome(VehicleStatus status, Altitude altitude) {
        if (altitude.reference() == Altitude.Reference.HOME) {
            return altitude.meters();
        }
        Double home = status.homeAltitudeAmslMeters();
        return home == null ? null : Double.valueOf(altitude.meters() - home);
    }

    /** Warn where the mission on board, when it is known, leaves the fence; never in the way of the command. */
    static List<ExchangeSequence.Step> warn(CommandContext cockpit) {
        if (cockpit.status().mission() == null) {
            return List.of();
        }
        OwnFenceReader reader = new OwnFenceReader(cockpit);
        List<ExchangeSequence.Step> steps = new ArrayList<>(reader.steps());
        steps.add(ExchangeSequence.Step.of(() -> new ImmediateExchange(() -> {
            warning(cockpit.status(), reader.fence()).ifPresent(cockpit.warning());
            return new Outcome.Succeeded();
        })));
        return steps;
    }

    private static Optional<String> warning(VehicleStatus status, OwnFence fence) {
        List<String> outside = new ArrayList<>();
        String first = "";
        for (OwnFence.Target target : targets(status)) {
            Optional<String> why = fence.against(status, target);
            if (why.isPresent()) {
                first = outside.isEmpty() ? why.get() : first;
                outside.add(target.words());
            }
        }
        if (!outside.isEmpty()) {
            String others = outside.stream()
                    .skip(1)
                    .map(words -> words.substring("Item ".length()))
                    .collect(Collectors.joining(", "));
            return Optional.of(
                    "The mission leaves the vehicle's own fence, where its FENCE_ACTION says what it does. " + first
                            + (others.isEmpty()
                                    ? ""
                                    : " Outside, too: " + (outside.size() == 2 ? "item " : "items ") + others + "."));
        }
        return fence.hasUnreadAreas()
                ? Optional.of(
                        "The vehicle's own fence has areas that were not compared with the mission; read its fence.")
                : Optional.empty();
    }

    private static List<OwnFence.Target> targets(VehicleStatus status) {
        List<MissionItemInt> items = status.mission();
        List<OwnFence.Target> targets = new ArrayList<>();
        Geodetic from = status.point();
        for (int seq = ArduPilotAdapter.HOME_ITEMS; items != null && seq < items.size(); seq++) {
            MissionItemInt item = items.get(seq);
            boolean upOrDown = UP_OR_DOWN.contains(item.command());
            if (!PLACES.contains(item.command()) && !upOrDown) {
                continue;
            }
            boolean placed = item.command() != MissionCodec.NAV_TAKEOFF
                    && (item.x() != 0 || item.y() != 0)
                    && FenceCodec.isPlace(item);
            Geodetic point = placed ? new Geodetic(item.x() / E7, item.y() / E7) : null;
            targets.add(new OwnFence.Target("Item " + seq, from, point, aboveHome(status, item), upOrDown));
            from = point == null ? from : point;
        }
        return targets;
    }

    private static @Nullable Double aboveHome(VehicleStatus status, MissionItemInt item) {
        Double home = status.homeAltitudeAmslMeters();
        return switch (item.frame()) {
            case MissionCodec.FRAME_RELATIVE, 6 -> Double.valueOf(item.z());
            case MissionCodec.FRAME_GLOBAL, 5 -> home == null ? null : Double.valueOf(item.z() - home);
            default -> null;
        };
    }
}
