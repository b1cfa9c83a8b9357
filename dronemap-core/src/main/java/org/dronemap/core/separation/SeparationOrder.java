package org.dronemap.core.separation;

import org.dronemap.core.command.Command;
import org.dronemap.core.drone.DroneId;

/**
 * A command that keeps two drones apart.
 *
 * @param to the drone that is commanded
 * @param why as a sentence
 */
public record SeparationOrder(DroneId to, Command command, String why) {}
