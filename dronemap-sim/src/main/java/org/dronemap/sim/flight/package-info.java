/**
 * What a vehicle does in flight, whatever its autopilot: body and sensors together, manoeuvres, missions; the clock is
 * passed in.
 *
 * <p>Enters: what flies alike under every autopilot.
 *
 * <p>Never: MAVLink.
 */
@NullMarked
package org.dronemap.sim.flight;

import org.jspecify.annotations.NullMarked;
