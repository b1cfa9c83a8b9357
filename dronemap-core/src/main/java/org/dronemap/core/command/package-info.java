/**
 * What may be asked of a drone, and the one outcome that every command ends in.
 *
 * <p>Enters: a type of command, with what it needs and does.
 *
 * <p>Never: how a vehicle is told.
 */
@NullMarked
package org.dronemap.core.command;

import org.jspecify.annotations.NullMarked;
