/**
 * Missions of a single drone, item by item.
 *
 * <p>Enters: a new kind of mission item.
 *
 * <p>Never: plans for several drones.
 */
@NullMarked
package org.dronemap.ws.mission;

import org.jspecify.annotations.NullMarked;
