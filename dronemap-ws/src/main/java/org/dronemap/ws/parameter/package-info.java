/**
 * Parameters on board of a vehicle.
 *
 * <p>Enters: use cases about parameters.
 *
 * <p>Never: what a parameter means to an autopilot.
 */
@NullMarked
package org.dronemap.ws.parameter;

import org.jspecify.annotations.NullMarked;
