package org.dronemap.core.virtual;

import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.mission.Mission;

/**
 * The order of a virtual drone's run: what is flown of the mission as it was planned when it was asked for, and how.
 *
 * @param ticket who asked first has the lower one, and goes first
 * @param mission a {@link VirtualTour}
 * @param onCloudLoss what a drone does by itself when it no longer hears the cloud
 * @param upTo so many drones may still share it; 1: it is one drone's
 */
public record VirtualRunOrder(long ticket, Mission mission, MissionCloudLossPolicy onCloudLoss, int upTo) {}
