/**
 * Commands to one drone or to several, and their outcomes.
 *
 * <p>Enters: a new type of command.
 *
 * <p>Never: what a command does at a vehicle.
 */
@NullMarked
package org.dronemap.ws.command;

import org.jspecify.annotations.NullMarked;
