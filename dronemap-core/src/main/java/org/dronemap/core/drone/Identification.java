package org.dronemap.core.drone;

import org.jspecify.annotations.Nullable;

/**
 * Identification that a vehicle reports of itself: kind, autopilot, firmware and hardware id.
 *
 * @param autopilot autopilot family as users know it, such as {@code ArduPilot} or {@code PX4}
 * @param vehicle firmware flavour as users know it, such as {@code ArduCopter}
 * @param firmware version such as {@code 4.5.6}; null until heard
 * @param hardwareUid the board's own id in hexadecimal; not secret, sometimes not unique; null until heard
 */
public record Identification(
        VehicleKind kind,
        String autopilot,
        String vehicle,
        @Nullable String firmware,
        @Nullable String hardwareUid) {}
