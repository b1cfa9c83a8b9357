package org.dronemap.proxy.mavlink.translate;

import java.util.Optional;
import java.util.Set;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.jspecify.annotations.Nullable;

/**
 * Explanation of changes to a mode that an ArduPilot vehicle refuses since it does not know where it is: it says which
 * mode it cannot have, or not even that, and not what is left.
 */
final class PositionlessModes {
    private static final Set<String> NEED_POSITION = Set.of(
            "AUTO",
            "GUIDED",
            "LOITER",
            "RTL",
            "SMART_RTL",
            "AUTO_RTL",
            "CIRCLE",
            "POSHOLD",
            "BRAKE",
            "FOLLOW",
            "ZIGZAG",
            "DOCK");

    private PositionlessModes() {}

    static Exchange explained(CommandContext cockpit, Exchange change, VehicleKind kind, String mode) {
        String left = whatIsLeft(kind);
        return left == null || !NEED_POSITION.contains(mode)
                ? change
                : new ExplainedExchange(
                        change,
                        said -> said.sentence().contains("requires position")
                                        || cockpit.status().hasLostItsPlace()
                                ? Optional.of(ExplainedExchange.after(said, OutcomeCode.POSITION_MISSING, left))
                                : Optional.empty());
    }

    /** Null for a kind that does not refuse modes for that. */
    private static @Nullable String whatIsLeft(VehicleKind kind) {
        return switch (kind) {
            case MULTICOPTER, HELICOPTER ->
                "Without a position it can land, or keep its height in ALT_HOLD while a pilot steers.";
            case ROVER, BOAT -> "Without a position it can stand in HOLD, or be driven by a pilot in MANUAL.";
            case SUBMARINE ->
                "Without a position it can keep its depth in ALT_HOLD, come up in SURFACE, or be steered by a pilot in"
                        + " MANUAL.";
            case FIXED_WING, VTOL, AIRSHIP, UNKNOWN -> null;
        };
    }
}
