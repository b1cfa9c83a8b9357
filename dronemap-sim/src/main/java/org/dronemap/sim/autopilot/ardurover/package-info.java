/**
 * A ground vehicle that answers and drives as ArduRover 4.5 does.
 *
 * <p>Enters: what ArduRover does, as recorded from a real one.
 *
 * <p>Never: what another autopilot does.
 */
@NullMarked
package org.dronemap.sim.autopilot.ardurover;

import org.jspecify.annotations.NullMarked;
