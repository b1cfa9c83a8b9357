package org.dronemap.core.virtual;

import java.time.Duration;
import java.time.Instant;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.separation.GiveWay;
import org.jspecify.annotations.Nullable;

/**
 * Observation of the real drone that serves a virtual drone's run; input of VirtualRunMachine.
 *
 * @param drone null: it was removed
 * @param whyNotHeld why the run has no control of it, as a sentence; null: it has
 * @param outcome of the last command; null: it has none yet, or there was no command
 * @param underWay the last command has no outcome yet
 * @param silence for how long nothing was heard
 * @param still for how long it has not moved from its place
 * @param mayFly the owner still may
 * @param giveWay to whom the drone gives way; null: to nobody
 */
public record VirtualRunObservation(
        @Nullable DroneState drone,
        @Nullable String whyNotHeld,
        @Nullable Outcome outcome,
        boolean underWay,
        Duration silence,
        Duration still,
        boolean mayFly,
        @Nullable GiveWay giveWay,
        Instant now) {}
