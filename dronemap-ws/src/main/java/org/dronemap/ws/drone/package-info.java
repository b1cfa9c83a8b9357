/**
 * Drones as users see them: state, sensors, places, what becomes of one by itself.
 *
 * <p>Enters: views of a drone, and use cases that change only how it is kept.
 *
 * <p>Never: commands.
 */
@NullMarked
package org.dronemap.ws.drone;

import org.jspecify.annotations.NullMarked;
