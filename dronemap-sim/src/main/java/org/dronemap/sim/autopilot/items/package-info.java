/**
 * Which mission items an autopilot takes, and what it keeps of each.
 *
 * <p>Enters: what firmware does to an item between upload and read-back, as recorded.
 *
 * <p>Never: how an item is flown; messages.
 */
@NullMarked
package org.dronemap.sim.autopilot.items;

import org.jspecify.annotations.NullMarked;
