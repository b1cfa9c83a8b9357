/**
 * What all simulated ArduPilot vehicles share: parameters, arming, modes, missions, commands and fail-safes.
 *
 * <p>Enters: what Copter, Rover and Plane do alike, as recorded from real ones.
 *
 * <p>Never: what only one of them does.
 */
@NullMarked
package org.dronemap.sim.autopilot.ardupilot;

import org.jspecify.annotations.NullMarked;
