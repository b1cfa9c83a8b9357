/**
 * Virtual drones: what users hold instead of a drone, and which drone serves them when and why.
 *
 * <p>Enters: a rule about virtual drones and who serves them.
 *
 * <p>Never: how drones are commanded.
 */
@NullMarked
package org.dronemap.core.virtual;

import org.jspecify.annotations.NullMarked;
